// The forms of files, the value of their key "exsect" (docs/formats.md).
#pragma once

#include <string>

namespace exsect {

/// Why a file of the form `stated` is refused where those of the form `needed` are read: what it holds, where
/// that is known, else that the version is unknown. Repeats of `stated` only what is printable.
std::string wrong_form(const std::string& stated, const std::string& needed);

}  // namespace exsect
