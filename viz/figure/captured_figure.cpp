#include "viz/figure/captured_figure.h"

#include "animation/body/foot_shape.h"
#include "animation/body/reference_pose.h"
#include "scenarios/captured_body.h"
#include "viz/figure/bone_figure.h"

namespace amble {

Figure capturedFigure(const Clip& clip, const JointRoles& roles) {
  if (!missingRole(roles).empty()) return makeBoneFigure(clip.skeleton);
  // The floor is as far below the ankles as an ankle is high.
  const double floor = lowestAnkle(clip, roles) - kAnkleHeightOfLeg * legOf(clip.skeleton, roles);
  return makeFigure(clip.skeleton,
                    capturedBody(clip, roles, floor, statureOf(clip.skeleton, roles)));
}

}  // namespace amble
