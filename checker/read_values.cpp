#include "read_values.h"

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

std::int64_t small(std::string_view digits) {
  std::int64_t n = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), n);
  return n;
}

/// The double that the number is, if this is easy to see: p odd, of 16 characters at most, q a power of 2.
std::optional<double> short_number(const NumberParts& parts) {
  if (parts.p.size() > 16 || parts.q.size() > 3) return std::nullopt;
  const std::int64_t p = small(parts.p);
  const std::int64_t q = small(parts.q);
  if (std::abs(p) > std::int64_t{1} << 53) return std::nullopt;
  if (parts.q.empty()) return static_cast<double>(p);
  if (p % 2 == 0 || (!parts.power && (q & (q - 1)) != 0)) return std::nullopt;
  return parts.power ? std::ldexp(static_cast<double>(p), -static_cast<int>(q))
                     : static_cast<double>(p) / static_cast<double>(q);
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

void read(Reader& in, std::size_t& n) { n = in.count(); }
void read(Reader& in, int& n) {
  const std::size_t count = in.count();
  require(count <= 0x7fffffff, "must be below 2^31");
  n = static_cast<int>(count);
}
void read(Reader& in, std::string& text) { text = in.string(); }
void read(Reader& in, Rational& q) {
  try {
    q = number_of(in.string());
  } catch (const std::invalid_argument& error) {
    throw Failed(error.what());
  }
}
void read(Reader& in, Enclosure& a) {
  Reader again = in.again(in.position());
  const std::optional<NumberParts> found = parts(in.string());
  if (const auto exact = found ? short_number(*found) : std::nullopt) {
    a = Enclosure(*exact);
    return;
  }
  Rational q;
  read(again, q);
  a = Enclosure(q);
}

}  // namespace exsect::checker
