// Everything but the adapters for other scalar types (number/), in the order in which data flow through the library.
#pragma once
#include <ricochet/version.hpp>

#include <ricochet/collide.hpp>

#include <ricochet/law/elastic/hertz.hpp>
#include <ricochet/law/elastic/linear.hpp>

#include <ricochet/law/adhesion/dmt.hpp>
#include <ricochet/law/adhesion/jkr.hpp>
#include <ricochet/law/adhesion/line_force.hpp>
#include <ricochet/law/adhesion/maugis_dugdale.hpp>

#include <ricochet/law/crack/greenwood.hpp>
#include <ricochet/law/crack/greenwood_fit.hpp>
#include <ricochet/law/crack/maugis_barquins.hpp>

#include <ricochet/law/damping/hunt_crossley.hpp>
#include <ricochet/law/damping/kuwabara_kono.hpp>
#include <ricochet/law/damping/linear_dashpot.hpp>
#include <ricochet/law/damping/tsuji.hpp>

#include <ricochet/law/tangential/coulomb.hpp>
#include <ricochet/law/tangential/coulomb_with_peeling.hpp>
#include <ricochet/law/tangential/mindlin.hpp>

#include <ricochet/law/plasticity/thornton_ning.hpp>
#include <ricochet/law/plasticity/thornton_ning_contact.hpp>

#include <ricochet/closed_form/brach_dunn.hpp>
#include <ricochet/closed_form/contact_duration.hpp>
#include <ricochet/closed_form/hertz.hpp>
#include <ricochet/closed_form/hunt_crossley.hpp>
#include <ricochet/closed_form/independent_losses.hpp>
#include <ricochet/closed_form/jkr.hpp>
#include <ricochet/closed_form/linear.hpp>
#include <ricochet/closed_form/maugis_dugdale.hpp>
#include <ricochet/closed_form/regime.hpp>
#include <ricochet/closed_form/rigid_body.hpp>
#include <ricochet/closed_form/thornton_ning.hpp>
#include <ricochet/closed_form/tsuji.hpp>
#include <ricochet/closed_form/viscoelastic_hertz.hpp>

#include <ricochet/model/physical_system.hpp>
#include <ricochet/model/regime.hpp>

#include <ricochet/solve/oblique/oblique.hpp>
#include <ricochet/solve/stepper/steppers.hpp>

#include <ricochet/study/fit/brach_dunn_fit.hpp>
#include <ricochet/study/sweep.hpp>
#include <ricochet/study/table.hpp>
#include <ricochet/study/threshold/threshold.hpp>
#include <ricochet/study/trajectory_table.hpp>
