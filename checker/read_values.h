// Numbers and lists of them in the text of a certificate: read(in, value) reads a value of each type.
#pragma once

#include "enclosure.h"
#include "reader.h"

namespace exsect::checker {

void read(Reader& in, std::size_t& n);
/// Below 2^31.
void read(Reader& in, int& n);
void read(Reader& in, std::string& text);
void read(Reader& in, Rational& q);
void read(Reader& in, Enclosure& a);
template <class T, std::size_t n>
void read(Reader& in, std::array<T, n>& values) {
  const std::size_t size = in.list([&](std::size_t i) {
    require(i < n, "has too many elements");
    read(in, values[i]);
  });
  require(size == n, "has too few elements");
}
template <class T>
void read(Reader& in, std::vector<T>& values) {
  in.list([&](std::size_t) { read(in, values.emplace_back()); });
}

}  // namespace exsect::checker
