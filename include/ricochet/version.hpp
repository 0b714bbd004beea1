// The one place of the version; the build system reads it here.
#pragma once

/// 10000 major + 100 minor + patch, for #if: the only macro that ricochet defines.
#define RICOCHET_VERSION 100

namespace ricochet {

inline constexpr const char* version = "0.1.0";

} // namespace ricochet
