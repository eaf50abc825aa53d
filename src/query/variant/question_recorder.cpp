#include "plumb/query/variant/question_recorder.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <map>
#include <mutex>
#include <span>
#include <utility>

#include "query/body/figure_text.hpp"
#include "query/variant/recorded.hpp"

namespace plumb {
namespace query {

std::atomic<QuestionRing*> living_ring{nullptr};

LineParts question_parts(std::string_view question, std::initializer_list<PosedView> figures,
                         std::initializer_list<double> numbers) {
  LineParts parts;
  parts.text(question);
  for (const PosedView& figure : figures) {
    parts.text(" | ");
    tell_figure(figure, parts);
  }
  if (numbers.size() != 0) {
    parts.word("|");
    parts.numbers({numbers.begin(), numbers.size()});
  }
  return parts;
}

namespace {

using Part = std::uint64_t;
using Parts = std::span<const Part>;

/// The first line, of eight parts, tells the version; the next part how many bytes the ring has.
constexpr std::string_view any_opening = "# questions and answers of plumb, in a ring";
constexpr std::string_view opening = "# questions and answers of plumb, in a ring, version 2         \n";
static_assert(opening.size() == 64 && opening.starts_with(any_opening));
constexpr std::size_t opening_bytes = opening.size() + sizeof(Part);

/// Before a question or an answer stands what it is, how many parts it has, and its line's number; behind it a sum of all.
constexpr Part mark = 0x706c'756d'6251'0000;  // "plumbQ"; the last 16 bits are zero but for an answer
constexpr std::size_t around = 4;             // parts besides
Part begin_of(bool is_answer) { return mark | (is_answer ? 1 : 0); }
Part sum_of_parts(Part begin, Part line, Parts parts) {
  Part sum = begin ^ line * 0x9e37'79b9'7f4a'7c15;
  for (const Part x : parts) sum = (sum ^ x) * 0x0000'0100'0000'01b3 + 1;
  return sum;
}

[[noreturn]] void refuse_file(const std::string& file, int error) {
  throw Error(file + ": cannot be made a ring of questions: " + std::strerror(error));
}

/// Memory that other processes see as the file, also after this one is gone.
char* mapped(const std::string& file, std::size_t bytes) {
  const int made = ::open(file.c_str(), O_CREAT | O_EXCL | O_RDWR | O_CLOEXEC, 0666);
  if (made == -1) refuse_file(file, errno);
  int error = ::posix_fallocate(made, 0, static_cast<off_t>(bytes));
  void* const at = error == 0 ? ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, made, 0) : MAP_FAILED;
  if (error == 0 && at == MAP_FAILED) error = errno;
  ::close(made);
  if (error != 0) {
    ::unlink(file.c_str());
    refuse_file(file, error);
  }
  return static_cast<char*>(at);
}

}  // namespace

class QuestionRing::Bytes {
 public:
  Bytes(char* at, std::size_t size, bool is_mapped) : all_(at, size), is_mapped_(is_mapped) {
    std::ranges::copy(opening, all_.begin());
    const Part bytes = size;
    std::memcpy(at + opening.size(), &bytes, sizeof bytes);
    body_ = all_.subspan(opening_bytes);
    parts_ = body_.size() / sizeof(Part);
  }
  Bytes(const Bytes&) = delete;
  Bytes& operator=(const Bytes&) = delete;
  ~Bytes() {
    if (is_mapped_) {
      ::munmap(all_.data(), all_.size());
    } else {
      delete[] all_.data();
    }
  }

  Place ask(const LineParts& question) {
    const std::lock_guard lock(one_at_a_time_);
    const Place place{++lines_, written_};
    write(false, place.line, question.kept());
    return place;
  }
  void answer(const Place& at, const LineParts& question, const LineParts& answer) {
    const std::lock_guard lock(one_at_a_time_);
    const std::size_t room = answer.kept().size() + around;
    if (written_ + room > at.written + parts_) write(false, at.line, question.kept());
    write(true, at.line, answer.kept());
  }
  [[nodiscard]] std::string content() const {
    const std::lock_guard lock(one_at_a_time_);
    return {all_.data(), all_.size()};
  }
  [[nodiscard]] std::size_t left_out() const {
    const std::lock_guard lock(one_at_a_time_);
    return left_out_;
  }

 private:
  /// What is written in part has no right sum, and is none.
  void write(bool is_answer, Part line, Parts parts) {
    const std::size_t size = parts.size() + around;
    if (size > parts_) {
      ++left_out_;
      return;
    }
    if (end_ + size > parts_) {
      std::ranges::fill(body_.subspan(end_ * sizeof(Part)), '\0');
      written_ += parts_ - end_, end_ = 0;
    }
    const Part begin = begin_of(is_answer), before[3]{begin, parts.size(), line},
               sum = sum_of_parts(begin, line, parts);
    char* const to = body_.data() + end_ * sizeof(Part);
    std::memcpy(to, before, sizeof before);
    std::memcpy(to + sizeof before, parts.data(), parts.size_bytes());
    std::memcpy(to + sizeof before + parts.size_bytes(), &sum, sizeof sum);
    std::atomic_signal_fence(std::memory_order_seq_cst);  // it is in the file before the question is asked
    end_ += size, written_ += size;
  }

  std::span<char> all_, body_;
  bool is_mapped_;
  mutable std::mutex one_at_a_time_;
  std::size_t parts_ = 0, end_ = 0, left_out_ = 0;
  Part lines_ = 0, written_ = 0;
};

QuestionRing::QuestionRing(std::size_t bytes) : bytes_(std::make_unique<Bytes>(new char[bytes](), bytes, false)) {}
QuestionRing::QuestionRing(const std::string& file, std::size_t bytes)
    : bytes_(std::make_unique<Bytes>(mapped(file, bytes), bytes, true)) {}
QuestionRing::~QuestionRing() = default;

QuestionRing::Place QuestionRing::ask(const LineParts& question) { return bytes_->ask(question); }
void QuestionRing::answer(const Place& at, const LineParts& question, const LineParts& answer) {
  bytes_->answer(at, question, answer);
}
std::string QuestionRing::content() const { return bytes_->content(); }
std::size_t QuestionRing::left_out() const { return bytes_->left_out(); }

namespace {

std::size_t require_room(std::size_t bytes) {
  if (bytes >= 1024) return bytes;
  throw Error("QuestionRecorder: a ring of " + std::to_string(bytes) + " bytes holds no question; give 1024 or more");
}
void begin_to_record(QuestionRing& ring) {
  QuestionRing* none = nullptr;
  if (!living_ring.compare_exchange_strong(none, &ring))
    throw Error("QuestionRecorder: another one lives; questions are kept by one at a time");
}

/// They are of a line that is kept; none of either is empty.
struct KeptLine {
  Parts question, answer;
};

std::vector<std::string> lines_of_ring(std::string_view content) {
  Part bytes = 0;
  if (content.size() >= opening_bytes) std::memcpy(&bytes, content.data() + opening.size(), sizeof bytes);
  if (bytes != content.size()) {
    throw Error("a ring of questions was cut: it should have " +
                (bytes == 0 ? "more than " + std::to_string(opening_bytes) : std::to_string(bytes)) +
                " bytes, and has " + std::to_string(content.size()) + "; take all of the file");
  }
  std::vector<Part> all((content.size() - opening_bytes) / sizeof(Part));
  if (!all.empty()) std::memcpy(all.data(), content.data() + opening_bytes, all.size() * sizeof(Part));
  std::map<Part, KeptLine> kept;
  for (std::size_t at = 0; at + around <= all.size();) {
    const Parts from = Parts(all).subspan(at);
    const bool is_answer = from[0] == begin_of(true);
    const bool is_one = (is_answer || from[0] == begin_of(false)) && from[1] <= from.size() - around;
    if (!is_one || sum_of_parts(from[0], from[2], from.subspan(3, from[1])) != from[3 + from[1]]) {
      ++at;
      continue;
    }
    KeptLine& line = kept[from[2]];
    (is_answer ? line.answer : line.question) = from.subspan(3, from[1]);
    at += from[1] + around;
  }
  std::vector<std::string> lines;
  for (const auto& [number, line] : kept) {
    if (line.question.empty()) continue;
    std::string text = LineParts::written(line.question);
    if (!line.answer.empty()) text.append(" =").append(LineParts::written(line.answer));
    lines.push_back(std::move(text));
  }
  return lines;
}

}  // namespace
}  // namespace query

QuestionRecorder::QuestionRecorder(std::size_t bytes)
    : ring_(std::make_unique<query::QuestionRing>(query::require_room(bytes))) {
  query::begin_to_record(*ring_);
}
QuestionRecorder::QuestionRecorder(const std::string& file, std::size_t bytes)
    : ring_(std::make_unique<query::QuestionRing>(file, query::require_room(bytes))) {
  query::begin_to_record(*ring_);
}
QuestionRecorder::~QuestionRecorder() { query::living_ring.store(nullptr); }

std::string QuestionRecorder::text() const {
  std::string text;
  for (const std::string& line : query::lines_of_ring(ring_->content())) text.append(line).append("\n");
  return text;
}
std::size_t QuestionRecorder::left_out() const { return ring_->left_out(); }

std::vector<std::string> recorded_lines(std::string_view content) {
  if (content.starts_with(query::opening)) return query::lines_of_ring(content);
  if (content.starts_with(query::any_opening)) {
    const std::string_view first = content.substr(0, content.find('\n'));
    throw Error("a ring of questions of another version, or cut: it begins with \"" + std::string(first) +
                "\"; version 2 is read here");
  }
  std::vector<std::string> lines;
  while (!content.empty()) {
    const std::size_t end = std::min(content.find('\n'), content.size());
    lines.emplace_back(content.substr(0, end));
    content.remove_prefix(std::min(end + 1, content.size()));
  }
  return lines;
}

}  // namespace plumb
