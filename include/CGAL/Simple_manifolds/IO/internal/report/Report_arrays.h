// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_REPORT_REPORT_ARRAYS_H
#define CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_REPORT_REPORT_ARRAYS_H

#include <CGAL/Simple_manifolds/Error.h>

#include <Eigen/Core>

#include <nlohmann/json.hpp>

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// The arrays of a report: a table in JSON, and all their bytes, compressed, as text. viewer/data.js reads it.
//
// The bytes of an array of items of s bytes are stored transposed, all first bytes, all second bytes, ...,
// which compresses far better. The processor is taken to be little endian, as browsers are.
class Report_arrays {
public:
  // Numbers as floats that keep `bits` of their 23 bits after the point: the rest only costs space.
  void add_values(const std::string& name, const std::vector<double>& values, int bits = 11)
  {
    std::vector<float> rounded;
    for (double x : values) rounded.push_back(round_to(x, bits));
    add(name, "f32", 1, rounded.data(), rounded.size());
  }

  template <class Vector>
  void add_vectors(const std::string& name, const std::vector<Vector>& vectors, int bits)
  {
    constexpr int n = Vector::RowsAtCompileTime;
    std::vector<std::array<float, n>> rounded(vectors.size());
    for (std::size_t i = 0; i < vectors.size(); ++i)
      for (int k = 0; k < n; ++k) rounded[i][k] = round_to(vectors[i][k], bits);
    add(name, "f32", n, rounded.data(), rounded.size());
  }

  // Unit vectors in units of 1/32767; no unit vector is zero.
  void add_unit_vectors(const std::string& name, const std::vector<Eigen::Vector3d>& vectors)
  {
    std::vector<std::array<std::int16_t, 3>> rounded(vectors.size());
    for (std::size_t i = 0; i < vectors.size(); ++i)
      for (int k = 0; k < 3; ++k)
        rounded[i][k] = vectors[i].allFinite() ? std::int16_t(std::lround(32767 * vectors[i][k])) : 0;
    add(name, "i16", 3, rounded.data(), rounded.size());
  }

  // From -32768 to 32767.
  void add_integers(const std::string& name, const std::vector<int>& values)
  {
    const std::vector<std::int16_t> rounded(values.begin(), values.end());
    add(name, "i16", 1, rounded.data(), rounded.size());
  }

  // Indices: each as its difference d from the one before, written as 2d or -2d-1.
  template <std::size_t N>
  void add_indices(const std::string& name, const std::vector<std::array<int, N>>& items)
  {
    std::vector<std::array<std::uint32_t, N>> coded(items.size());
    int previous = 0;
    for (std::size_t i = 0; i < items.size(); ++i)
      for (std::size_t k = 0; k < N; ++k) {
        const int d = items[i][k] - previous;
        coded[i][k] = d >= 0 ? 2u * unsigned(d) : 2u * unsigned(-(d + 1)) + 1u;
        previous = items[i][k];
      }
    add(name, "index", int(N), coded.data(), coded.size());
  }

  // Per array its type, components per item, number of items and first byte.
  const nlohmann::ordered_json& table() const { return table_; }

  // All bytes in zlib's format, in base 64.
  std::string text() const
  {
    uLongf size = compressBound(uLong(bytes_.size()));
    std::vector<unsigned char> packed(size);
    if (compress2(packed.data(), &size, reinterpret_cast<const Bytef*>(bytes_.data()), uLong(bytes_.size()),
                  Z_BEST_COMPRESSION) != Z_OK)
      throw IO_error(Error_code::cannot_write, "report", "the data cannot be compressed");
    packed.resize(size);
    return base64(packed);
  }

private:
  template <class Item>
  void add(const std::string& name, const char* type, int components, const Item* items, std::size_t n)
  {
    table_[name] = {{"type", type}, {"components", components}, {"size", n}, {"first", bytes_.size()}};
    const std::size_t first = bytes_.size();
    bytes_.resize(first + n * sizeof(Item));
    for (std::size_t i = 0; i < n; ++i) {
      char item[sizeof(Item)];
      std::memcpy(item, items + i, sizeof item);
      for (std::size_t k = 0; k < sizeof(Item); ++k) bytes_[first + k * n + i] = item[k];
    }
  }

  static float round_to(double x, int bits)
  {
    if (!std::isfinite(x) || x == 0) return float(x);
    int exponent;
    const double fraction = std::frexp(x, &exponent);
    return float(std::ldexp(std::round(std::ldexp(fraction, bits + 1)), exponent - bits - 1));
  }

  static std::string base64(std::vector<unsigned char> bytes)
  {
    static constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const std::size_t n = bytes.size();
    bytes.resize((n + 2) / 3 * 3);
    std::string text;
    text.reserve(bytes.size() / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
      const unsigned group = unsigned(bytes[i]) << 16 | unsigned(bytes[i + 1]) << 8 | bytes[i + 2];
      for (int shift = 18; shift >= 0; shift -= 6) text += digits[group >> shift & 63];
    }
    std::fill(text.end() - std::ptrdiff_t(bytes.size() - n), text.end(), '=');
    return text;
  }

  nlohmann::ordered_json table_ = nlohmann::ordered_json::object();
  std::string bytes_;
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_REPORT_REPORT_ARRAYS_H
