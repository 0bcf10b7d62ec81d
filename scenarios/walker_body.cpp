#include "scenarios/walker_body.h"

#include "animation/body/foot_shape.h"
#include "animation/body/reference_pose.h"

namespace amble {

Body walkerBody(const WalkSynthesizer& walker, const MotionLibrary& library) {
  const BodyStance stance{
      .upright = referenceOf(walker.skeleton(), walker.roles(), library.stand().rotations),
      .head = walker.standingHead()};
  return makeBody(walker.skeleton(), walker.roles(), walker.stature(), soleHeights(walker.feet()),
                  stance);
}

}  // namespace amble
