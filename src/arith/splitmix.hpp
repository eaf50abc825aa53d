// Which integers look as if by chance, and are the same on every machine?  The stream splitmix64.
//
// Source: Steele, Lea and Flood 2014, "Fast splittable pseudorandom number generators".
// Cost: some 1 ns.
#pragma once

#include <cstdint>

namespace plumb {

inline constexpr std::uint64_t golden_step = 0x9e3779b97f4a7c15;  // 2^64 over the golden ratio

/// A permutation of 64 bits: what differs in one of them differs in about half.
constexpr std::uint64_t mixed_bits(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9;
  x = (x ^ (x >> 27)) * 0x94d049bb133111eb;
  return x ^ (x >> 31);
}

/// The next of the stream.
constexpr std::uint64_t splitmix64(std::uint64_t& state) { return mixed_bits(state += golden_step); }

}  // namespace plumb
