#include "tool/csg/syntax.hpp"

#include <cctype>

#include "plumb/arith/error.hpp"
#include "plumb/surface/file/decimal.hpp"
#include "tool/terminal/terminal.hpp"

namespace plumb::tool {
namespace {

bool begins_name(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '$'; }
bool is_in_name(char c) { return begins_name(c) || std::isdigit(static_cast<unsigned char>(c)) != 0; }
bool is_in_number(char c) { return is_in_name(c) || c == '.' || c == '+' || c == '-'; }

class CsgText {
 public:
  CsgText(std::string_view text, const std::string& name) : text_(text), name_(name) {}

  std::vector<CsgCall> all() {
    std::vector<CsgCall> calls;
    while (skip_space(), at_ < text_.size()) put_call(calls);
    return calls;
  }

 private:
  [[noreturn]] void fail(const std::string& text) const { fail_at(name_, line_, text); }
  [[noreturn]] void fail_expecting(const std::string& what) const {
    if (at_ == text_.size()) fail("the text ends where " + what + " is expected");
    std::size_t end = at_ + 1;
    while (end < text_.size() && end < at_ + 20 && is_in_name(text_[at_]) && is_in_name(text_[end])) ++end;
    fail("'" + printable(std::string(text_.substr(at_, end - at_))) + "' stands where " + what + " is expected");
  }

  void skip_space() {
    while (at_ < text_.size()) {
      if (text_.substr(at_).starts_with("//")) {
        while (at_ < text_.size() && text_[at_] != '\n') ++at_;
      } else if (text_.substr(at_).starts_with("/*")) {
        const std::size_t end = text_.find("*/", at_ + 2);
        if (end == text_.npos) fail("a comment begins with /* and has no end; close it with */");
        for (; at_ < end + 2; ++at_) line_ += text_[at_] == '\n' ? 1 : 0;
      } else if (std::isspace(static_cast<unsigned char>(text_[at_])) != 0) {
        line_ += text_[at_++] == '\n' ? 1 : 0;
      } else {
        return;
      }
    }
  }
  bool takes(char c) {
    skip_space();
    if (at_ == text_.size() || text_[at_] != c) return false;
    ++at_;
    return true;
  }
  void require(char c) {
    if (!takes(c)) fail_expecting(std::string("'") + c + "'");
  }
  std::string name_here(const std::string& what) {
    skip_space();
    if (at_ == text_.size() || !begins_name(text_[at_])) fail_expecting(what);
    const std::size_t begin = at_;
    while (at_ < text_.size() && is_in_name(text_[at_])) ++at_;
    return std::string(text_.substr(begin, at_ - begin));
  }

  /// What is nested is counted while this lives.
  struct Nested {
    explicit Nested(CsgText& text) : of(text) {
      if (++of.depth_ > deepest_nesting) of.fail("brackets are nested deeper than " + std::to_string(deepest_nesting));
    }
    ~Nested() { --of.depth_; }
    Nested(const Nested&) = delete;
    Nested& operator=(const Nested&) = delete;
    CsgText& of;
  };

  void put_call(std::vector<CsgCall>& calls) {
    const Nested nested(*this);
    if (takes(';')) return;
    bool is_left_out = false;
    for (skip_space(); at_ < text_.size(); skip_space()) {
      if (text_[at_] == '!') fail("the mark '!' is not known here; leave out what it hides");
      if (text_[at_] != '*' && text_[at_] != '%' && text_[at_] != '#') break;
      is_left_out = is_left_out || text_[at_] != '#';
      ++at_;
    }
    CsgCall call{name_here("the name of a solid or an operation"), {}, {}, line_};
    require('(');
    while (!takes(')')) {
      if (!call.arguments.empty()) require(',');
      put_argument(call);
    }
    if (takes('{')) {
      while (!takes('}')) {
        if (at_ == text_.size()) fail_expecting("'}'");
        put_call(call.children);
      }
    } else if (!takes(';')) {
      put_call(call.children);  // the one child, without braces
    }
    if (!is_left_out) calls.push_back(std::move(call));
  }

  void put_argument(CsgCall& call) {
    skip_space();
    const std::size_t begin = at_;
    if (at_ < text_.size() && begins_name(text_[at_])) {
      std::string name = name_here("");
      if (takes('=')) return call.arguments.emplace_back(std::move(name), value()), void();
      at_ = begin;  // a word that is a value: true
    }
    call.arguments.emplace_back("", value());
  }

  CsgValue value() {
    const Nested nested(*this);
    if (takes('[')) {
      std::vector<CsgValue> all;
      while (!takes(']')) {
        if (!all.empty()) require(',');
        if (all.empty() || !takes(']'))
          all.push_back(value());
        else
          break;  // a comma before the end
      }
      return {std::move(all)};
    }
    if (takes('"')) return {quoted()};
    skip_space();
    const std::size_t begin = at_;
    while (at_ < text_.size() && is_in_number(text_[at_])) ++at_;
    const std::string_view word = text_.substr(begin, at_ - begin);
    if (word == "true" || word == "false") return {word == "true"};
    if (word == "undef") return {};
    double number = 0;
    if (!word.empty() && decimals_.read(word, number) == DecimalReader::Outcome::number) return {number};
    at_ = begin;
    fail_expecting("a finite number, a word in quotes, true, false, undef or a list");
  }

  std::string quoted() {
    std::string word;
    while (at_ < text_.size() && text_[at_] != '"' && text_[at_] != '\n') {
      if (text_[at_] == '\\' && at_ + 1 < text_.size()) ++at_;
      word += text_[at_++];
    }
    if (at_ == text_.size() || text_[at_] != '"') fail("a quote is not closed on its line");
    ++at_;
    return word;
  }

  std::string_view text_;
  const std::string& name_;
  std::size_t at_ = 0;
  std::uint64_t line_ = 1;
  int depth_ = 0;
  DecimalReader decimals_;
};

}  // namespace

void fail_at(const std::string& name, std::uint64_t line, const std::string& text) {
  throw Error(printable(name) + ":" + std::to_string(line) + ": " + text);
}

std::vector<CsgCall> parse_csg(std::string_view text, const std::string& name) { return CsgText(text, name).all(); }

}  // namespace plumb::tool
