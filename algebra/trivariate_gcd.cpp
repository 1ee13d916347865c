#include "trivariate_gcd.h"

#include <stdexcept>

#include "flint.h"
// after flint.h
#include <flint/fmpq_mpoly.h>

namespace exsect {
namespace {

/// The ring Q[r,s,u].
class TrivariateContext {
 public:
  TrivariateContext() { fmpq_mpoly_ctx_init(context_, 3, ORD_LEX); }
  ~TrivariateContext() { fmpq_mpoly_ctx_clear(context_); }
  TrivariateContext(const TrivariateContext&) = delete;
  TrivariateContext& operator=(const TrivariateContext&) = delete;

  const fmpq_mpoly_ctx_struct* get() const { return context_; }

 private:
  fmpq_mpoly_ctx_t context_;
};

/// Owner of one element; the context must outlive it.
class FlintTrivariate {
 public:
  explicit FlintTrivariate(const TrivariateContext& ring) : ring_(ring) {
    fmpq_mpoly_init(value, ring_.get());
  }
  FlintTrivariate(const TrivariateContext& ring, const TrivariateCoefficients& f) : FlintTrivariate(ring) {
    FlintRational c;
    for (std::size_t i = 0; i < f.size(); ++i)
      for (std::size_t j = 0; j < f[i].size(); ++j)
        for (int k = 0; k <= f[i][j].degree(); ++k) {
          fmpq_set_mpq(c.value, f[i][j].coefficient(k).backend().data());
          const ulong exponents[] = {static_cast<ulong>(i), static_cast<ulong>(j), static_cast<ulong>(k)};
          fmpq_mpoly_set_coeff_fmpq_ui(value, c.value, exponents, ring_.get());
        }
  }
  ~FlintTrivariate() { fmpq_mpoly_clear(value, ring_.get()); }
  FlintTrivariate(const FlintTrivariate&) = delete;
  FlintTrivariate& operator=(const FlintTrivariate&) = delete;

  TrivariateCoefficients coefficients() const {
    std::vector<std::vector<std::vector<Rational>>> table;
    FlintRational c;
    for (slong term = 0; term < fmpq_mpoly_length(value, ring_.get()); ++term) {
      ulong e[3];
      fmpq_mpoly_get_term_exp_ui(e, value, term, ring_.get());
      fmpq_mpoly_get_term_coeff_fmpq(c.value, value, term, ring_.get());
      if (table.size() <= e[0]) table.resize(e[0] + 1);
      if (table[e[0]].size() <= e[1]) table[e[0]].resize(e[1] + 1);
      std::vector<Rational>& in_u = table[e[0]][e[1]];
      if (in_u.size() <= e[2]) in_u.resize(e[2] + 1);
      in_u[e[2]] = c.to_rational();
    }
    TrivariateCoefficients result;
    for (const auto& row : table) {
      result.emplace_back();
      for (const std::vector<Rational>& in_u : row) result.back().emplace_back(in_u);
    }
    return result;
  }

  fmpq_mpoly_t value;

 private:
  const TrivariateContext& ring_;
};

}  // namespace

TrivariateCoefficients gcd(const TrivariateCoefficients& a, const TrivariateCoefficients& b) {
  const TrivariateContext ring;
  const FlintTrivariate first(ring, a);
  const FlintTrivariate second(ring, b);
  FlintTrivariate common(ring);
  if (fmpq_mpoly_gcd(common.value, first.value, second.value, ring.get()) == 0)
    throw std::runtime_error("gcd: the trivariate gcd failed");
  return common.coefficients();
}

}  // namespace exsect
