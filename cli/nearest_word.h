// What a misspelt word may have meant.
#pragma once

#include <string>
#include <vector>

namespace exsect::cli {

/// The least number of letters that are inserted, left out, replaced, or exchanged with their neighbour, to
/// turn one word into the other (optimal string alignment distance).
std::size_t edit_distance(const std::string& a, const std::string& b);

/// The first of the known words with the least distance from `word`, if that is at most a third of its
/// length; else the first that begins with it, if it has three letters or more; "" if there is none.
std::string nearest_word(const std::string& word, const std::vector<std::string>& known);

}  // namespace exsect::cli
