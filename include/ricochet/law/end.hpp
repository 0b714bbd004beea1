#pragma once
#include <ricochet/law/role.hpp>

namespace ricochet {

/// A contact without adhesion cannot pull: it ends where the force vanishes, before the overlap does. The default.
struct end_at_zero_force {
  using role = role::end;
};

/// The end most published constants assume, Krijt 2013 (26) among them: the contact pulls until the overlap vanishes.
struct end_at_zero_overlap {
  using role = role::end;
};

} // namespace ricochet
