/// What most often stood in the way of a walk, from the refusals of a search: for the report of why
/// there is none.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "planner/plan_request.h"
#include "planner/steering/steering.h"

namespace amble {

/// An object as reports name it: its name in the scene, with that of its part of a mesh file where
/// it is one.
std::string nameOf(const SceneObject& object);

/// The refusals in few words: the rule and object that refused most often, of these the part of the
/// body that did, and one of the places where it happened. None where nothing was refused.
std::optional<Obstruction> mostOften(const std::vector<SteeringFailure>& refusals,
                                     const Scene& scene, const Body& body);

}  // namespace amble
