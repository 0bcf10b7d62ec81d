/// What leg_lanes.h says, of four frames at once, written once for every instruction set (lanes.h).
#pragma once

#include "animation/body/two_link_lanes.h"
#include "animation/synthesis/leg_lanes.h"
#include "base/lanes.h"

namespace amble {
namespace {

inline Point pointAt(const double* from) {
  return {loaded(from), loaded(from + 4), loaded(from + 8)};
}
inline void storePoint(double* to, const Point& p) {
  store(to, p.x), store(to + 4, p.y), store(to + 8, p.z);
}
inline Turn quadAt(const double* from) {
  return {loaded(from), loaded(from + 4), loaded(from + 8), loaded(from + 12)};
}
inline void storeQuad(double* to, const Turn& q) {
  store(to, q.x), store(to + 4, q.y), store(to + 8, q.z), store(to + 12, q.w);
}
inline Turn same(const double* q) {
  return {q[0] + Lanes{}, q[1] + Lanes{}, q[2] + Lanes{}, q[3] + Lanes{}};
}
inline Turn normalized(const Turn& q) {
  const Lanes scale = 1.0 / root(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w);
  return {scale * q.x, scale * q.y, scale * q.z, scale * q.w};
}

// A joint of the chain: its rotation, and behind it its place.
inline const double* jointAt(const LaneLegFrames& frames, int chain) {
  return frames.joints + kLaneJoint * chain;
}

inline void placeChainLanes(const LaneLegs& legs, const double* const position[4],
                            const double* const rotations[4], LaneLegFrames& frames) {
  storeQuad(frames.joints, turnAt(rotations, 0));
  for (int k = 0; k < 3; ++k)
    store(frames.joints + 16 + 4 * k,
          Lanes{position[0][k], position[1][k], position[2][k], position[3][k]});
  for (int i = 1; i < legs.joints; ++i) {
    const double* parent = jointAt(frames, legs.parent[i]);
    double* here = frames.joints + kLaneJoint * i;
    const Turn q = quadAt(parent);
    storeQuad(here, product(q, turnAt(rotations, legs.joint[i])));
    storePoint(here + 16, placed(q, pointAt(parent + 16), legs.offset + 3 * i));
  }
}

// soleFrame. Exactly upright where the normal is.
inline Turn soleTurn(const LaneSoles& soles) {
  const SinCos half = sinCos(0.5 * loaded(soles.heading));
  const Point n = unit(pointAt(soles.normal));
  const Lanes s = root(2.0 * (1.0 + n.z)), over = 1.0 / s;
  const Turn heading = {Lanes{}, Lanes{}, half.sine, half.cosine};
  return product({-n.y * over, n.x * over, Lanes{}, 0.5 * s}, heading);
}

// Half of what the toes are bent by: they stay as they lie while the heel is up.
inline void storeToes(const LaneSoles& soles, const SinCos& half_pitch,
                      LaneLegFrames::Target& target) {
  const double* toes = soles.toes;
  const Lanes pitch = loaded(soles.pitch);
  const LaneBits up = pitch < 0.0;
  if (toes[0] != 0.0 || toes[1] != 0.0 || toes[2] != 0.0 || toes[3] != 0.0) {
    const SinCos half = sinCos(0.5 * ((up ? Lanes{} : pitch) - loaded(toes)));
    store(target.toe, half.sine);
    store(target.toe + 4, half.cosine);
    return;
  }
  store(target.toe, up ? Lanes{} : half_pitch.sine);
  store(target.toe + 4, up ? Lanes{} + 1.0 : half_pitch.cosine);
}

inline void aimLanes(const LaneLeg& leg, const LaneSoles& soles, LaneLegFrames& frames) {
  const Turn q_WS = soleTurn(soles);
  const Lanes pitch = loaded(soles.pitch);
  const SinCos half = sinCos(0.5 * pitch), roll = sinCos(0.5 * loaded(soles.roll));
  const Lanes c = half.cosine * half.cosine - half.sine * half.sine,
              s = 2.0 * half.sine * half.cosine;
  const LaneBits toes_up = pitch < 0.0;
  // rolledAnkle: about y, +x goes down.
  const Lanes pivot = toes_up ? leg.heel_x + Lanes{} : leg.ball_x + Lanes{};
  const Lanes x = leg.ankle_x - pivot, z = leg.ankle_height - leg.radius + Lanes{};
  const Point rolled = {pivot + c * x + s * z, Lanes{}, leg.radius - s * x + c * z};
  const Point ankle = placed(q_WS, pointAt(soles.position), rolled);
  const Turn about_y = {Lanes{}, half.sine, Lanes{}, half.cosine},
             about_x = {roll.sine, Lanes{}, Lanes{}, roll.cosine};
  const Point hip = pointAt(jointAt(frames, leg.up_leg.chain) + 16);
  LaneLegFrames::Target& target = frames.targets[leg.side];
  storePoint(target.ankle, ankle);
  storeQuad(target.q_WF, product(product(product(q_WS, about_y), about_x), same(leg.q_SF)));
  storeToes(soles, half, target);
  const Point away = hip - pointAt(soles.position);
  storePoint(target.hip_S, placed(conjugate(q_WS), Point{}, away));
  const Point ahead = placedAt(q_WS, Point{}, 1.0, 0.0, 0.0);
  store(target.behind,
        (away.x - leg.ball_x * ahead.x) * ahead.x + (away.y - leg.ball_x * ahead.y) * ahead.y);
  store(target.distance, length(ankle - hip));
  store(target.captured, length(pointAt(jointAt(frames, leg.foot.chain) + 16) - hip));
}

// Turns one leg to its target. Joints between (twist joints of some rigs) turn with the link above
// them.
inline LaneBits turnLeg(const LaneLeg& leg, const LaneLegFrames& frames,
                        double* const rotations[4]) {
  const LaneLegFrames::Target& target = frames.targets[leg.side];
  const auto q = [&](int chain) { return quadAt(jointAt(frames, chain)); };
  const auto p = [&](int chain) { return pointAt(jointAt(frames, chain) + 16); };
  const Turn up = q(leg.up_leg.chain);
  const LegLanes links = {p(leg.up_leg.chain), p(leg.leg.chain), p(leg.foot.chain),
                          placed(up, Point{}, leg.knee_axis)};
  const LegTurns turns = solveLegs(links, pointAt(target.ankle));
  const Lanes longest =
      leg.longest * (length(links.knee - links.hip) + length(links.ankle - links.knee));
  const auto turn = [&](const LaneLeg::Bone& bone, const Turn& q_WParent, const Turn& q_WJ) {
    storeTurn(rotations, bone.joint, normalized(product(conjugate(q_WParent), q_WJ)));
  };
  turn(leg.up_leg, q(leg.up_leg.parent), product(turns.thigh, up));
  turn(leg.leg, product(turns.thigh, q(leg.leg.parent)), product(turns.shank, q(leg.leg.chain)));
  turn(leg.foot, product(turns.shank, q(leg.foot.parent)), quadAt(target.q_WF));
  const Lanes bend = -loaded(target.toe);
  storeTurn(rotations, leg.toe,
            product(same(leg.q_FT), {bend * leg.lateral_T[0], bend * leg.lateral_T[1],
                                     bend * leg.lateral_T[2], loaded(target.toe + 4)}));
  return turns.solved & (loaded(target.distance) <= longest);
}

inline void lowerLanes(const LaneLegs& legs, const LaneLegFrames& frames, double missing[4]) {
  Lanes most = {};
  for (const LaneLeg& leg : legs.legs) {
    const Point hip = pointAt(jointAt(frames, leg.up_leg.chain) + 16);
    const Point d = hip - pointAt(frames.targets[leg.side].ankle);
    const Lanes longest = loaded(frames.targets[leg.side].longest);
    const Lanes room = longest * longest - (d.x * d.x + d.y * d.y);
    most = larger(most, d.z - root(larger(room, Lanes{})));
  }
  store(missing, most);
}

inline void reachLanes(const LaneLegs& legs, const LaneLegFrames& frames,
                       double* const rotations[4], bool reached[4]) {
  const LaneBits both =
      turnLeg(legs.legs[0], frames, rotations) & turnLeg(legs.legs[1], frames, rotations);
  for (int lane = 0; lane < 4; ++lane) reached[lane] = both[lane] != 0;
}

}  // namespace
}  // namespace amble
