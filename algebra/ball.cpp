#include "ball.h"

#include <new>

#include "flint.h"
#include "rounding_bounds.h"

namespace exsect {

DoubleBall DoubleBall::enclosing(const Rational& q) {
  const double m = to_double(q);
  if (from_double(m) == q) {
    return m;
  }
  // Nearest rounding: the error is at most u|m|, or 2^-1075 below the normal range.
  return {m, up(std::fabs(m) * 0x1p-53)};
}

DoubleBall DoubleBall::enclosing(const RationalInterval& interval) {
  const DoubleBall centre = enclosing(interval.midpoint());
  const DoubleBall half = enclosing(interval.width() / 2);
  return centre.widened(half.upper_magnitude());
}

DoubleBall DoubleBall::between(double lower, double upper) {
  // Half the sum of both is rounded once, and both differences: 2^-50 covers them.
  const double middle = lower / 2 + upper / 2;
  return DoubleBall(middle).widened((upper - lower) / 2 + std::fabs(middle) * 0x1p-50);
}

DoubleBall hull(const DoubleBall& a, const DoubleBall& b) {
  // Each end is rounded by less than 2^-52 of it, which widens the whole.
  const double lower = -larger_bound(a.radius() - a.approximation(), b.radius() - b.approximation());
  const double upper = larger_bound(a.approximation() + a.radius(), b.approximation() + b.radius());
  return DoubleBall::between(lower, upper).widened((std::fabs(lower) + std::fabs(upper)) * 0x1p-52);
}

RationalInterval DoubleBall::interval() const {
  const Rational mid = from_double(mid_);
  const Rational rad = from_double(rad_);
  return {mid - rad, mid + rad};
}

namespace detail {

static_assert(sizeof(arb_struct) == 48 && alignof(arb_struct) <= 8);

namespace {

arb_ptr arb(unsigned char* bytes) { return std::launder(reinterpret_cast<arb_ptr>(bytes)); }
arb_srcptr arb(const unsigned char* bytes) { return std::launder(reinterpret_cast<arb_srcptr>(bytes)); }

}  // namespace

ArbStorage::ArbStorage() {
  new (bytes_) arb_struct;
  arb_init(arb(bytes_));
}
ArbStorage::ArbStorage(double x) : ArbStorage() { arb_set_d(arb(bytes_), x); }
ArbStorage::ArbStorage(const ArbStorage& other) : ArbStorage() { arb_set(arb(bytes_), arb(other.bytes_)); }
ArbStorage::ArbStorage(ArbStorage&& other) noexcept : ArbStorage() {
  arb_swap(arb(bytes_), arb(other.bytes_));
}
ArbStorage& ArbStorage::operator=(const ArbStorage& other) {
  arb_set(arb(bytes_), arb(other.bytes_));
  return *this;
}
ArbStorage& ArbStorage::operator=(ArbStorage&& other) noexcept {
  arb_swap(arb(bytes_), arb(other.bytes_));
  return *this;
}
ArbStorage::~ArbStorage() { arb_clear(arb(bytes_)); }

void ArbStorage::set_interval(const Rational& lower, const Rational& upper, long bits) {
  const FlintRational a(lower);
  arb_set_fmpq(arb(bytes_), a.value, bits);
  if (lower != upper) {
    const FlintRational b(upper);
    ArbStorage end;
    arb_set_fmpq(arb(end.bytes_), b.value, bits);
    arb_union(arb(bytes_), arb(bytes_), arb(end.bytes_), bits);
  }
}
void ArbStorage::set_midpoint_of(const ArbStorage& a) { arb_get_mid_arb(arb(bytes_), arb(a.bytes_)); }
void ArbStorage::widen(double r) {
  ArbStorage radius(r);
  arb_add_error(arb(bytes_), arb(radius.bytes_));
}
void ArbStorage::negate() { arb_neg(arb(bytes_), arb(bytes_)); }
void ArbStorage::add(const ArbStorage& a, const ArbStorage& b, long bits) {
  arb_add(arb(bytes_), arb(a.bytes_), arb(b.bytes_), bits);
}
void ArbStorage::subtract(const ArbStorage& a, const ArbStorage& b, long bits) {
  arb_sub(arb(bytes_), arb(a.bytes_), arb(b.bytes_), bits);
}
void ArbStorage::multiply(const ArbStorage& a, const ArbStorage& b, long bits) {
  arb_mul(arb(bytes_), arb(a.bytes_), arb(b.bytes_), bits);
}
void ArbStorage::add_product(const ArbStorage& a, const ArbStorage& b, long bits) {
  arb_addmul(arb(bytes_), arb(a.bytes_), arb(b.bytes_), bits);
}

double ArbStorage::approximation() const { return arf_get_d(arb_midref(arb(bytes_)), ARF_RND_NEAR); }
double ArbStorage::radius() const { return mag_get_d(arb_radref(arb(bytes_))); }
double ArbStorage::upper_magnitude() const {
  arf_t bound;
  arf_init(bound);
  arb_get_abs_ubound_arf(bound, arb(bytes_), 64);
  const double result = arf_get_d(bound, ARF_RND_CEIL);
  arf_clear(bound);
  return result;
}
double ArbStorage::lower_magnitude() const {
  arf_t bound;
  arf_init(bound);
  arb_get_abs_lbound_arf(bound, arb(bytes_), 64);
  const double result = arf_get_d(bound, ARF_RND_FLOOR);
  arf_clear(bound);
  return result;
}
int ArbStorage::certain_sign() const {
  return arb_is_positive(arb(bytes_)) ? 1 : arb_is_negative(arb(bytes_)) ? -1 : 0;
}

RationalInterval ArbStorage::interval() const {
  const Rational mid = to_rational(arb_midref(arb(bytes_)));
  arf_t radius;
  arf_init(radius);
  arf_set_mag(radius, arb_radref(arb(bytes_)));
  const Rational rad = to_rational(radius);
  arf_clear(radius);
  return {mid - rad, mid + rad};
}

}  // namespace detail

}  // namespace exsect
