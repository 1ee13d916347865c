// The claims that all certificates have in common, as JSON with their seals.
#pragma once

#include <exsect/checker/check_certificate.h>
#include <exsect/geometry/number.h>

#include <string>
#include <vector>

#include "certificate/search.h"
#include "output/text/json_forms.h"

namespace exsect::cli {

/// $.list[i]
std::string in_list(const char* list, std::size_t i);
/// json.dump(), of objects whose keys have nothing to escape, with what is `verbatim` as it stands.
std::string compact_text(const Json& json);
/// JSON that is written as this text stands: a long list, say, as JSON takes its time.
Json verbatim(const std::string& text);
/// The claim with its seal.
Json sealed(const std::string& place, Json claim);
/// The rational that a finite double is, p/q or p/2^n.
std::string exact_number(double a);
/// The same after the text.
void append_number(std::string& text, double a);
/// The same of each.
Json exact_numbers(const std::vector<double>& numbers);
template <class Numbers>
Json exact(const Numbers& numbers) {
  return exact_numbers({numbers.begin(), numbers.end()});
}
template <class Numbers>
Json rationals(const Numbers& numbers) {
  Json result = Json::array();
  for (const Rational& q : numbers) result.push_back(to_string(q));
  return result;
}
/// u, v, r, s.
const char* letter(std::size_t parameter);

/// pair, star3u+.
std::string map_text(const checker::MapName& map);

Json patch_claim(const std::string& place, const std::string& name, const RationalPatch& patch);
Json equation_claim(const std::string& place, const std::string& name, const SpacePolynomial& f);
Json tube_claims(const NearPair& pair, const std::vector<Tube>& tubes);
Json cover_claims(const std::vector<std::string>& entries);

/// The document with one claim a line.
std::string claims_text(const Json& document);
NoCertificate not_accepted(const checker::Rejected& rejected);
/// The text, if it is accepted, with greater error bounds of arcs perhaps; otherwise throws NoCertificate.
std::string accepted_text(Json document);
/// The same with no change.
std::string confirmed(const std::string& certificate);

}  // namespace exsect::cli
