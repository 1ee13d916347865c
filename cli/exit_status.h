// The exit statuses of every command.
#pragma once

namespace exsect::cli {

enum class ExitStatus : int {
  complete = 0,       // the whole answer, proved; also --help and --version
  negative = 1,       // a check that was asked for came out negative
  failed = 2,         // bad input or usage, or the output could not be written; stdout is empty
  incomplete = 3,     // the answer says where and why it is not complete
  interrupted = 128,  // plus the number of the signal that ended a batch
};

}  // namespace exsect::cli
