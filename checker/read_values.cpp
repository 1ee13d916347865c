#include "read_values.h"

#include <bit>

#include "certificate.h"

namespace exsect::checker {
namespace {

/// Without leading zeros and a plus sign.
bool is_integer(std::string_view text) {
  if (text.substr(0, 1) == "-")
    return text.size() > 1 && text[1] != '0' && text[1] != '-' && is_integer(text.substr(1));
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  return !text.empty() && std::all_of(text.begin(), text.end(), is_digit) &&
         (text[0] != '0' || text.size() == 1);
}

/// p and q or n of the texts p, p/q and p/2^n.
struct NumberParts {
  std::string_view p;
  std::string_view q;
  bool power = false;
};
std::optional<NumberParts> parts(std::string_view text) {
  const std::size_t slash = text.find('/');
  NumberParts result = {text.substr(0, slash), {}};
  if (!is_integer(result.p)) return std::nullopt;
  if (slash == std::string_view::npos) return result;
  result.q = text.substr(slash + 1);
  result.power = result.q.substr(0, 2) == "2^";
  if (result.power) result.q.remove_prefix(2);
  const bool valid =
      is_integer(result.q) && result.q[0] != '-' && result.q != "0" && (result.power || result.q != "1");
  return valid ? std::optional(result) : std::nullopt;
}

/// Takes the character off if the text begins with it.
bool skip(std::string_view& text, char c) {
  const bool there = !text.empty() && text[0] == c;
  if (there) text.remove_prefix(1);
  return there;
}
/// Takes off a positive integer without leading zeros, of so many digits at most; 0 if there is none.
std::int64_t skip_positive(std::string_view& text, std::size_t most) {
  std::int64_t n = 0;
  std::size_t length = 0;
  for (; length < text.size() && text[length] >= '0' && text[length] <= '9'; ++length) {
    if (length == most || text[0] == '0') return 0;
    n = 10 * n + (text[length] - '0');
  }
  text.remove_prefix(length);
  return n;
}

/// The double that the number is, if this is easy to see: p odd, of 16 digits at most, q a power of 2.
std::optional<double> short_number(std::string_view text) {
  if (text == "0") return 0.0;
  const double sign = skip(text, '-') ? -1 : 1;
  const std::int64_t p = skip_positive(text, 16);
  if (p == 0 || p > std::int64_t{1} << 53) return std::nullopt;
  const double value = sign * static_cast<double>(p);
  if (text.empty()) return value;
  if (p % 2 == 0 || !skip(text, '/')) return std::nullopt;
  std::int64_t q = skip_positive(text, 3);
  const bool power = q == 2 && skip(text, '^');
  if (power) q = skip_positive(text, 3);
  if (q == 0 || !text.empty()) return std::nullopt;
  if (power)
    return value *
           std::bit_cast<double>(static_cast<std::uint64_t>(1023 - q) << 52);  // 2^-q, exactly: q < 1000
  return q > 1 && (q & (q - 1)) == 0 ? std::optional(value / static_cast<double>(q)) : std::nullopt;
}

}  // namespace

Rational number_of(std::string_view text) {
  if (text.size() > max_number_characters)
    throw std::invalid_argument("a number of more than 6100 characters");
  const std::optional<NumberParts> found = parts(text);
  if (!found) throw std::invalid_argument("must be p/q in lowest terms, p/2^n with p odd, or p");
  const Integer p{std::string(found->p)};
  const Integer q{found->q.empty() ? "1" : std::string(found->q)};
  if (!found->power) {
    Rational value(p, q);
    if (numerator(value) == p && denominator(value) == q) return value;
  } else if (p % 2 != 0 && q >= 1 && q <= 2000) {
    return Rational(p) * power_of_two(-static_cast<long>(q));
  }
  throw std::invalid_argument("must be p/q in lowest terms, p/2^n with p odd, or p");
}

namespace {

Rational required_number(std::string_view text) {
  try {
    return number_of(text);
  } catch (const std::invalid_argument& error) {
    throw Failed(error.what());
  }
}

}  // namespace

void read(Reader& in, std::size_t& n) { n = in.count(); }
void read(Reader& in, int& n) {
  const std::size_t count = in.count();
  require(count <= 0x7fffffff, "must be below 2^31");
  n = static_cast<int>(count);
}
void read(Reader& in, std::string& text) { text = in.string(); }
void read(Reader& in, Rational& q) { q = required_number(in.string()); }
void read(Reader& in, Enclosure& a) {
  const std::string_view text = in.string();
  const std::optional<double> exact = short_number(text);
  a = exact ? Enclosure(*exact) : Enclosure(required_number(text));
}

}  // namespace exsect::checker
