// Numbers as text, read and written exactly.
#pragma once

#include <exsect/algebra/rational.h>

#include <string>
#include <string_view>

namespace exsect {

/// Documented sizes beyond which a number is refused: length of the text in characters, magnitude of a
/// decimal or binary exponent, decimal digits of the numerator and of the denominator of the value in lowest
/// terms. Every value within `max_number_digits` can be written by to_string and read back.
inline constexpr std::size_t max_number_length = 6100;
inline constexpr int max_number_exponent = 3000;
inline constexpr int max_number_digits = 3000;

/// The rational number that the text is, exactly. The text must be one of
///
///     [sign] digits "/" digits                                   3/7, -4/6 (= -2/3), 03/7
///     [sign] digits ["." digits] [("e" | "E") [sign] digits]      12, 0.1 (= 1/10), -2.5e-3
///     [sign] ("0x" | "0X") hexdigits ["." hexdigits] ("p" | "P") [sign] digits      0x1.8p-3 (= 3/16)
///
/// with sign "+" or "-", from the first to the last character: no blanks, no NaN, no infinity, no sign in a
/// denominator, digits on both sides of a point. A fraction need not be in lowest terms; the value is. Throws
/// std::invalid_argument, with the text (shortened) and the reason, for anything else, for a zero denominator
/// and beyond the sizes above.
Rational parse_number(std::string_view text);

/// The same, but a decimal means the IEEE binary64 number nearest to it (ties to even), exactly: 0.1 is
/// 3602879701896397/2^55. A decimal that rounds to infinity throws std::invalid_argument. Fractions of
/// integers and hexadecimal numbers mean what they say.
Rational parse_binary64(std::string_view text);

/// "p/q" in lowest terms with q > 1, or "p": the canonical text.
std::string to_string(const Rational& q);

}  // namespace exsect
