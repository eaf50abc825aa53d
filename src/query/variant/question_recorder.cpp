#include "plumb/query/variant/question_recorder.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <mutex>
#include <span>
#include <utility>

#include "certify/case_line.hpp"
#include "query/body/figure_text.hpp"
#include "query/variant/recorded.hpp"

namespace plumb {
namespace query {

std::atomic<QuestionRing*> living_ring{nullptr};

std::string question_text(std::string_view question, std::initializer_list<PosedView> figures,
                          std::initializer_list<double> numbers) {
  std::string text(question);
  for (const PosedView& figure : figures) text.append(" | ").append(figure_line(figure));
  if (numbers.size() != 0) text.append(" |");
  for (const double x : numbers) {
    text += ' ';
    append_hexadecimal(text, x);
  }
  return text;
}

namespace {

constexpr std::string_view opening = "# questions and answers of plumb, in a ring\n";
constexpr std::string_view numbered = "  # ";

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
    body_ = all_.subspan(opening.size());
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

  std::uint64_t ask(std::string_view question) {
    const std::lock_guard lock(one_at_a_time_);
    const std::uint64_t line = ++lines_;
    write(line, question);
    return line;
  }
  /// Behind the question, if that is the last line and there is room; else as a line of its own.
  void answer(std::uint64_t line, std::string_view question, std::string_view answer) {
    const std::lock_guard lock(one_at_a_time_);
    const std::string told = std::string(" = ").append(answer);
    const std::size_t behind = last_begin_ + question.size();
    const std::string rest = ended(line, told);
    if (line != last_line_ || behind + rest.size() + 1 > body_.size())
      return write(line, std::string(question).append(told));
    end_ = behind + rest.size();
    body_[end_] = '\0';
    std::atomic_signal_fence(std::memory_order_seq_cst);
    std::ranges::copy(rest, body_.begin() + static_cast<std::ptrdiff_t>(behind));
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
  static std::string ended(std::uint64_t line, std::string_view text) {
    return std::string(text).append(numbered).append(std::to_string(line)).append("\n");
  }
  /// A NUL stands before what is written until that is whole, and one behind it.
  void write(std::uint64_t line, std::string_view text) {
    const std::string whole = ended(line, text);
    if (whole.size() + 1 > body_.size()) {
      ++left_out_;
      return;
    }
    if (end_ + whole.size() + 1 > body_.size()) {
      std::ranges::fill(body_.subspan(end_), '\0');
      end_ = 0;
    }
    body_[end_] = '\0';
    std::atomic_signal_fence(std::memory_order_seq_cst);  // a signal's handler, and the file, see these in order
    std::ranges::copy(std::string_view(whole).substr(1), body_.begin() + static_cast<std::ptrdiff_t>(end_) + 1);
    body_[end_ + whole.size()] = '\0';
    std::atomic_signal_fence(std::memory_order_seq_cst);
    body_[end_] = whole[0];
    last_line_ = line;
    last_begin_ = std::exchange(end_, end_ + whole.size());
  }

  std::span<char> all_, body_;
  bool is_mapped_;
  mutable std::mutex one_at_a_time_;
  std::uint64_t lines_ = 0, last_line_ = 0;
  std::size_t last_begin_ = 0, end_ = 0, left_out_ = 0;
};

QuestionRing::QuestionRing(std::size_t bytes) : bytes_(std::make_unique<Bytes>(new char[bytes](), bytes, false)) {}
QuestionRing::QuestionRing(const std::string& file, std::size_t bytes)
    : bytes_(std::make_unique<Bytes>(mapped(file, bytes), bytes, true)) {}
QuestionRing::~QuestionRing() = default;

std::uint64_t QuestionRing::ask(std::string_view question) { return bytes_->ask(question); }
void QuestionRing::answer(std::uint64_t line, std::string_view question, std::string_view answer) {
  bytes_->answer(line, question, answer);
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

struct NumberedLine {
  std::uint64_t number;
  std::string_view text;
};

/// Nothing of a line whose begin was overwritten.
void tell_chunk(std::string_view chunk, std::vector<NumberedLine>& lines) {
  while (!chunk.empty()) {
    const std::size_t end = chunk.find('\n');
    if (end == chunk.npos) return;
    const std::string_view line = chunk.substr(0, end);
    chunk.remove_prefix(end + 1);
    const std::size_t mark = line.rfind(numbered);
    if (mark == line.npos) continue;
    const std::string_view digits = line.substr(mark + numbered.size());
    NumberedLine read{0, line.substr(0, mark)};
    if (std::from_chars(digits.data(), digits.data() + digits.size(), read.number).ec == std::errc())
      lines.push_back(read);
  }
}

std::vector<std::string> lines_of_ring(std::string_view body) {
  std::vector<NumberedLine> found;
  for (std::size_t at = 0; at < body.size();) {
    const std::size_t end = std::min(body.find('\0', at), body.size());
    std::string_view chunk = body.substr(at, end - at);
    if (at != 0) chunk.remove_prefix(std::min(chunk.find('\n'), chunk.size()));
    tell_chunk(chunk, found);
    at = end + 1;
  }
  // A question that was answered after others has a line without the answer as well, which is shorter.
  std::ranges::sort(found, {}, [](const NumberedLine& line) { return std::pair(line.number, line.text.size()); });
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const bool is_told_again = i + 1 < found.size() && found[i + 1].number == found[i].number;
    if (!is_told_again) lines.emplace_back(found[i].text);
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
  for (const std::string& line : recorded_lines(ring_->content())) text.append(line).append("\n");
  return text;
}
std::size_t QuestionRecorder::left_out() const { return ring_->left_out(); }

std::vector<std::string> recorded_lines(std::string_view content) {
  if (content.starts_with(query::opening)) return query::lines_of_ring(content.substr(query::opening.size()));
  std::vector<std::string> lines;
  while (!content.empty()) {
    const std::size_t end = std::min(content.find('\n'), content.size());
    lines.emplace_back(content.substr(0, end));
    content.remove_prefix(std::min(end + 1, content.size()));
  }
  return lines;
}

}  // namespace plumb
