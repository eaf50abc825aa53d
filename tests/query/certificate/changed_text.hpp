// What is the text of a certificate with a byte, a word or a member changed?
//
// Law: the same texts and number, the same change.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "arith/splitmix.hpp"

namespace plumb::certificate_laws {

/// One change of a certificate, or several; the same number, the same change.
class ChangedText {
  // Before they are called, as one deduces what it returns.
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(splitmix64(state_) % n); }
  template <class List>
  auto any(const List& list) {
    return *(list.begin() + static_cast<std::ptrdiff_t>(below(list.size())));
  }

 public:
  ChangedText(const std::vector<std::string>& texts, std::uint64_t number) : texts_(texts), state_(number) {
    const std::string whole = any(texts_);
    text_ = whole;
    for (std::size_t k = below(4) == 0 ? 1 + below(3) : 1; k > 0; --k) change();
    if (text_ == whole) how_ = "nothing";
  }
  [[nodiscard]] const std::string& how() const { return how_; }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::size_t place() { return below(text_.size() + 1); }

  void change() {
    if (text_.empty()) text_ = any(texts_);
    switch (below(10)) {
      case 0:
        return flip_bit();
      case 1:
        return insert_blank();
      case 2:
        return insert_byte();
      case 3:
        return cut_piece();
      case 4:
        return repeat_piece();
      case 5:
        return replace_word();
      case 6:
        return replace_word_by_another();
      case 7:
        return rename_member();
      case 8:
        return add_member();
      default:
        return swap_bodies();
    }
  }
  void flip_bit() {
    how_ = "a flipped bit";
    char& byte = text_[below(text_.size())];
    byte = static_cast<char>(byte ^ (1 << below(8)));
  }
  void insert_blank() {
    how_ = "a blank between words";
    const std::size_t at = text_.find_first_of(",:[]{}", place());
    text_.insert(at == text_.npos ? text_.size() : at, 1, any(std::string_view(" \t\r")));
  }
  void insert_byte() {
    how_ = "a byte more";
    static constexpr std::string_view bytes("\0\n\v\x7f\xa0\xff\"\\,:[]{}-+.0eEpPxX/", 26);
    text_.insert(place(), 1, any(bytes));
  }
  void cut_piece() {
    how_ = "a piece less";
    text_.erase(below(text_.size()), 1 + below(below(4) == 0 ? 60 : 3));
  }
  void repeat_piece() {
    how_ = "a piece twice";
    text_.insert(place(), text_.substr(below(text_.size()), 1 + below(40)));
  }
  /// A text in quotes or a number, of which there is one in every certificate as it was written.
  struct Word {
    std::size_t at, size;
  };
  std::vector<Word> words() const {
    std::vector<Word> all;
    for (std::size_t at = 0; at < text_.size(); ++at) {
      std::size_t end = at;
      if (text_[at] == '"') {
        end = std::min(text_.find('"', at + 1), text_.size() - 1) + 1;
      } else {
        while (end < text_.size() && text_[end] >= '0' && text_[end] <= '9') ++end;
      }
      if (end > at) all.push_back({at, end - at}), at = end - 1;
    }
    return all;
  }
  void replace(const Word& word, std::string_view by) { text_.replace(word.at, word.size, by); }
  void replace_word() {
    how_ = "another word";
    static const std::array<std::string_view, 36> others{"\"-0x0p+0\"",
                                                         "\"0x0p+0\"",
                                                         "\"0x1p+0\"",
                                                         "\"0x1.0p+0\"",
                                                         "\"0X1p+0\"",
                                                         "\"0x1p0\"",
                                                         "\"0x1.fffffffffffffp+1023\"",
                                                         "\"0x1p+1024\"",
                                                         "\"0x1p-1074\"",
                                                         "\"0x1p-1075\"",
                                                         "\"0x0.0000000000001p-1022\"",
                                                         "\"infinity\"",
                                                         "\"nan\"",
                                                         "\"\"",
                                                         "\"1\"",
                                                         "\"-1\"",
                                                         "\"1/3\"",
                                                         "\"2/6\"",
                                                         "\"-1/3\"",
                                                         "\"01\"",
                                                         "\"0\"",
                                                         "\"-0\"",
                                                         "\"1e3\"",
                                                         "0",
                                                         "1",
                                                         "-0",
                                                         "2.0",
                                                         "1e400",
                                                         "NaN",
                                                         "Infinity",
                                                         "null",
                                                         "true",
                                                         "[]",
                                                         "{}",
                                                         "\"claim\"",
                                                         "\"\\u0000\""};
    if (const auto all = words(); !all.empty()) replace(any(all), any(others));
  }
  void replace_word_by_another() {
    how_ = "a word at another's place";
    const auto all = words();
    if (all.empty()) return;
    const Word from = any(all);
    replace(any(all), text_.substr(from.at, from.size));
  }
  void rename_member() {
    how_ = "another name";
    static const std::array<std::string_view, 17> names{
        "claim",    "distance", "square", "inset",  "direction", "pairs", "a",    "b",      "weight",
        "vertices", "radius",   "min",    "corner", "edges",     "half",  "pose", "columns"};
    const std::string name = "\"" + std::string(any(names)) + "\":";
    const std::size_t at = text_.find(name);
    if (at == text_.npos) return;
    std::string other = "\"" + std::string(any(names)) + "\":";
    if (below(2) == 0) other = name, other[1] = static_cast<char>(other[1] ^ 0x20);
    text_.replace(at, name.size(), other);
  }
  void add_member() {
    how_ = "a member more";
    static const std::array<std::string_view, 8> members{
        R"("radius":"0x1p+0",)",  R"("Radius":"0x1p+0",)",         R"("poses":{},)", R"("a":0,)", R"("note":null,)",
        R"("claim":"disjoint",)", R"("direction":["1","0","0"],)", R"("pairs":[],)"};
    const std::size_t at = text_.find('{', below(text_.size()));
    if (at != text_.npos) text_.insert(at + 1, any(members));
  }
  /// Another proof where the pair lies evenly, as of two equal points.
  void swap_bodies() {
    how_ = "bodies exchanged";
    for (const std::string_view body : {"\"a\":{", "\"b\":{"}) {
      if (const std::size_t at = text_.find(body); at != text_.npos) text_[at + 1] = body[1] == 'a' ? 'B' : 'a';
    }
    if (const std::size_t at = text_.find("\"B\":{"); at != text_.npos) text_[at + 1] = 'b';
  }

  const std::vector<std::string>& texts_;
  std::uint64_t state_;
  std::string text_, how_;
};

}  // namespace plumb::certificate_laws
