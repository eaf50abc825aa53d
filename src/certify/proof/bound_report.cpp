#include "plumb/certify/bound_report.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <vector>

#include "certify/case_line.hpp"
#include "plumb/certify/proof_script.hpp"

namespace plumb {
namespace {

/// With a point, whatever the locale.
std::string decimal(double x, int decimals) {
  std::array<char, 512> text;  // room for the greatest double
  const auto end = std::to_chars(text.data(), text.data() + text.size(), x, std::chars_format::fixed, decimals).ptr;
  return {text.data(), end};
}

/// A number with nine decimals, rounded up.
std::string with_decimals(double x) { return decimal(std::ceil(x * 1e9) / 1e9, 9); }

std::string counted(double n, const std::string& what) { return decimal(n, 0) + " " + what + (n == 1 ? "" : "s"); }

}  // namespace

BoundReport bound_report(std::string_view name, const certify::tape::Program& program, double constant) {
  std::vector<int> degree(program.arity, 1);
  std::vector<BitLength> bits(program.arity, BitLength{53});
  bool homogeneous = true;
  for (const certify::tape::Instruction& i : program.instructions) {
    const bool product = i.operation == '*';
    const int left = degree[i.left], right = degree[i.right];
    homogeneous = homogeneous && (product || left == right);
    degree.push_back(product ? left + right : std::max(left, right));
    bits.push_back(product ? bits[i.left] * bits[i.right] : bits[i.left] + bits[i.right]);
  }
  return {name,     degree.back(),   homogeneous, program.instructions.size(), count_terms(program),
          constant, bits.back().bits};
}

std::string to_string(const BoundReport& r) {
  std::string text(r.name);
  text.append(r.homogeneous ? ": degree " : ": terms of different degree, up to ").append(std::to_string(r.degree));
  text.append(", ").append(counted(static_cast<double>(r.operations), "operation"));
  text.append(", ").append(counted(r.terms, "term")).append("\nerror: at most ");
  text.append(with_decimals(r.constant * 0x1p53)).append(" * 2^-53 of the sum of the terms' magnitudes (");
  text.append(hexadecimal(r.constant)).append(")\nvalue: ").append(std::to_string(r.value_bits));
  return text.append(" bits for coordinates of 53 bits\n");
}

}  // namespace plumb
