// The exit codes of the program, besides 0 and 128 + a signal's number.
#pragma once

namespace lacuna::cli {

inline constexpr int kExitCheckFailed = 1;
inline constexpr int kExitBadUsage = 2;
inline constexpr int kExitFile = 3;
inline constexpr int kExitDevice = 4;
inline constexpr int kExitBug = 70;  // EX_SOFTWARE of sysexits.h

}  // namespace lacuna::cli
