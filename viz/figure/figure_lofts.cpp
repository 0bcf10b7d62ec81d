#include "viz/figure/figure_lofts.h"

#include <algorithm>
#include <cmath>

#include "viz/figure/model_pose.h"

namespace amble {

using Eigen::Vector3d;

namespace {

using Paint = std::array<std::uint8_t, 3>;
constexpr Paint kSkin = {205, 172, 150}, kHair = {74, 62, 56}, kShirt = {120, 144, 166},
                kTrousers = {74, 82, 98}, kShoes = {52, 50, 52};

// Lengths below are of the mean man of the survey (1.756 m) [m]; those of radii without a source
// were chosen by eye, within the capsules that the survey's breadths and girths gave.
constexpr double kHeadRadius = 0.568 / (2.0 * 3.14159265358979);

class FigureMaker {
 public:
  FigureMaker(const Body& body, std::span<const JointFrame> frames)
      : body_(body), frames_(frames), size_(sizeOf(body)) {}

  std::vector<LoftGroup> make() {
    trunk();
    head();
    for (const Side side : {kLeft, kRight}) {
      leg(side);
      foot(side);
      arm(side);
    }
    return std::move(groups_);
  }

 private:
  const BodyPart& part(const char* name) const { return body_.parts[findPart(body_, name)]; }
  const BodyPart& part(Side side, const char* name) const {
    return body_.parts[findPart(body_, side, name)];
  }
  Vector3d from(const BodyPart& p) const { return frames_[p.joint] * p.from; }
  Vector3d to(const BodyPart& p) const { return frames_[p.joint] * p.to; }
  Vector3d at(const BodyPart& p) const { return frames_[p.joint].p_WJ; }
  Vector3d middle(const BodyPart& p) const { return 0.5 * (from(p) + to(p)); }
  LoftEnd end(const Vector3d& p, double radius, double half = 0.0) const {
    return {p, radius * size_, half * size_};
  }
  Vector3d metres(double x, double y, double z) const { return size_ * Vector3d(x, y, z); }

  void open(double blend) { groups_.push_back({{}, blend * size_, {}}); }
  void add(const LoftEnd& a, const LoftEnd& b, std::array<int, 2> joints, const Paint& color,
           double blend, const Vector3d& across = Vector3d::UnitY()) {
    groups_.back().lofts.push_back({a, b, across, joints, blend * size_, color});
  }

  void trunk() {
    open(0.03);
    const BodyPart &pelvis = part("pelvis"), &abdomen = part("abdomen"), &chest = part("chest");
    const BodyPart& neck = part("neck");
    const LoftEnd hips = end(middle(pelvis), 0.112, 0.052),
                  waist = end(middle(abdomen), 0.098, 0.046),
                  ribs = end(middle(chest), 0.108, 0.048);
    const LoftEnd belt = end(0.6 * middle(pelvis) + 0.4 * middle(abdomen), 0.106, 0.049);
    add(hips, belt, {pelvis.joint, pelvis.joint}, kTrousers, 0.02);
    add(belt, waist, {pelvis.joint, abdomen.joint}, kShirt, 0.02);
    add(waist, ribs, {abdomen.joint, chest.joint}, kShirt, 0.02);
    const Vector3d shoulders = 0.5 * (at(part(kLeft, "upper arm")) + at(part(kRight, "upper arm")));
    const LoftEnd top = end(shoulders - metres(0.005, 0, 0.055), 0.07, 0.09);
    add(ribs, top, {chest.joint, chest.joint}, kShirt, 0.03);
    add(end(shoulders - metres(0.01, 0, 0.01), 0.05, 0.06),
        end(0.5 * (shoulders + from(neck)) + metres(-0.008, 0, 0.02), 0.048),
        {chest.joint, chest.joint}, kShirt, 0.04);
    for (const Side side : {kLeft, kRight}) {
      const double out = side == kLeft ? 1.0 : -1.0;
      const Vector3d hip = at(part(side, "thigh"));
      const LoftEnd seat = end(hip + metres(-0.026, -0.016 * out, 0.0), 0.08);
      add(seat, seat, {pelvis.joint, pelvis.joint}, kTrousers, 0.03);
    }
  }

  void head() {
    const BodyPart &neck = part("neck"), &head = part("head"), &chest = part("chest");
    const Vector3d nape = to(neck), chin = from(head), crown = to(head);
    const Vector3d up =
        (crown - chin).norm() > 1e-9 ? Vector3d((crown - chin).normalized()) : Vector3d::UnitZ();
    const auto place = [&](double ahead, double above) -> Vector3d {
      return chin + size_ * (ahead * Vector3d::UnitX() + (above - kHeadRadius) * up);
    };
    open(0.03);
    const int low = neck.joint == chest.joint ? chest.joint : neck.joint;
    add(end(from(neck) - metres(0.0, 0, 0.01), 0.052), end(nape, 0.05), {low, low}, kSkin, 0.02);
    add(end(nape, 0.05), end(place(-0.004, 0.09), 0.046), {low, head.joint}, kSkin, 0.02);
    open(0.012);
    const std::array<int, 2> joints = {head.joint, head.joint};
    const double top = (crown - chin).norm() / size_ + 2.0 * kHeadRadius;  // chin to crown
    const Vector3d fore = Vector3d::UnitX();
    add(end(place(-0.014, top - 0.076), 0.075, 0.011), end(place(-0.012, top - 0.09), 0.075, 0.011),
        joints, kHair, 0.01, fore);
    add(end(place(0.022, top - 0.098), 0.066), end(place(0.036, 0.046), 0.043), joints, kSkin,
        0.02);
    add(end(place(0.082, 0.122), 0.009), end(place(0.094, 0.09), 0.014), joints, kSkin, 0.012);
  }

  void arm(Side side) {
    const BodyPart &collar = part(side, "shoulder"), &upper = part(side, "upper arm"),
                   &fore = part(side, "forearm"), &hand = part(side, "hand");
    const Vector3d shoulder = at(upper), elbow = at(fore), wrist = from(hand);
    const Vector3d along = (to(hand) - from(hand)).normalized();
    open(0.03);
    add(end(from(collar) - metres(0, 0, 0.012), 0.042), end(shoulder, 0.05),
        {collar.joint, collar.joint}, kShirt, 0.02);
    add(end(shoulder, 0.05), end(0.4 * elbow + 0.6 * shoulder, 0.047), {upper.joint, upper.joint},
        kShirt, 0.015);
    add(end(0.4 * elbow + 0.6 * shoulder, 0.047), end(elbow, 0.041), {upper.joint, upper.joint},
        kShirt, 0.015);
    add(end(elbow, 0.041), end(0.3 * wrist + 0.7 * elbow, 0.043), {fore.joint, fore.joint}, kShirt,
        0.012);
    add(end(0.3 * wrist + 0.7 * elbow, 0.043), end(wrist, 0.028), {fore.joint, fore.joint}, kShirt,
        0.012);
    mitten(hand, wrist, along);
  }

  // Palm, fingers and thumb; palms face the thighs when the arms hang.
  void mitten(const BodyPart& hand, const Vector3d& wrist, const Vector3d& along) {
    const Vector3d fore = (Vector3d::UnitX() - along.x() * along).normalized();
    const std::array<int, 2> joints = {hand.joint, hand.joint};
    const double length = ((to(hand) - from(hand)).norm() + hand.radius) / size_;
    const auto place = [&](double share, double ahead) -> Vector3d {
      return wrist + size_ * (share * length * along + ahead * fore);
    };
    add(end(place(0.02, 0), 0.021, 0.008), end(place(0.48, 0), 0.016, 0.025), joints, kSkin, 0.012,
        fore);
    add(end(place(0.48, 0), 0.016, 0.025), end(place(0.9, -0.003), 0.014, 0.016), joints, kSkin,
        0.01, fore);
    add(end(place(0.2, 0.024), 0.016), end(place(0.56, 0.048), 0.013), joints, kSkin, 0.01);
  }

  void leg(Side side) {
    const BodyPart &thigh = part(side, "thigh"), &shank = part(side, "shank");
    const Vector3d hip = at(thigh), knee = at(shank), ankle = at(part(side, "instep"));
    const auto between = [](const Vector3d& a, const Vector3d& b, double t) -> Vector3d {
      return a + t * (b - a);
    };
    open(0.04);
    const std::array<int, 2> upper = {thigh.joint, thigh.joint}, lower = {shank.joint, shank.joint};
    add(end(between(hip, knee, 0.02), 0.083), end(between(hip, knee, 0.4), 0.074), upper, kTrousers,
        0.02);
    add(end(between(hip, knee, 0.4), 0.074), end(knee, 0.055), upper, kTrousers, 0.012);
    const LoftEnd calf = end(between(knee, ankle, 0.3) - metres(0.008, 0, 0), 0.055);
    add(end(knee, 0.055), calf, lower, kTrousers, 0.012);
    add(calf, end(between(knee, ankle, 0.92), 0.038), lower, kTrousers, 0.012);
  }

  // Within the sole's capsules and the instep's, flat below.
  void foot(Side side) {
    const BodyPart &outside = part(side, "sole, outside"), &inside = part(side, "sole, inside");
    const BodyPart &toes = part(side, "toes"), &instep = part(side, "instep");
    const Vector3d ball = 0.5 * (to(outside) + to(inside)), heel = from(outside);
    const Vector3d along = (ball - heel).normalized();
    const Vector3d aside = (to(outside) - to(inside)).norm() > 1e-9
                               ? Vector3d((to(outside) - to(inside)).normalized())
                               : Vector3d::UnitY();
    const Vector3d up = Vector3d::UnitZ(), under = heel - outside.radius * up;
    const double half = 0.5 * (to(outside) - to(inside)).norm() / size_ + outside.radius / size_;
    const auto over = [&](const Vector3d& p, double height) -> Vector3d {
      return p + (under.z() + height * size_ - p.z()) * up;
    };
    open(0.015);
    groups_.back().floor = {up, under.z()};
    const std::array<int, 2> rear = {outside.joint, outside.joint},
                             front = {toes.joint, toes.joint};
    const double tall = std::clamp((at(instep) - under).z() / size_, 0.03, 0.1);  // the ankle
    const LoftEnd back = end(over(heel + 0.02 * size_ * along, 0.022), 0.033),
                  sole = end(over(ball, 0.016), 0.026, std::max(0.0, half - 0.026)),
                  tip = end(
                      over(to(toes) - std::max(0.0, 0.018 * size_ - toes.radius) * along, 0.011),
                      0.018, std::max(0.0, 0.7 * half - 0.018));
    add(back, sole, rear, kShoes, 0.015, aside);
    add(sole, tip, front, kShoes, 0.015, aside);
    add(end(over(at(instep), tall), 0.037),
        end(over(ball - 0.25 * (ball - heel), 0.024), 0.03, 0.008), rear, kShoes, 0.02, aside);
    add(end(over(at(instep), tall), 0.037), end(over(heel + 0.02 * size_ * along, 0.03), 0.032),
        rear, kShoes, 0.02, aside);
  }

  const Body& body_;
  std::span<const JointFrame> frames_;
  const double size_;
  std::vector<LoftGroup> groups_;
};

}  // namespace

double sizeOf(const Body& body) {
  const int head = findPart(body, "head");
  return head >= 0 ? body.parts[head].radius / kHeadRadius : 0.0;
}

std::vector<LoftGroup> figureLofts(const Body& body, std::span<const JointFrame> frames) {
  if (isPerson(body)) return FigureMaker(body, frames).make();
  std::vector<LoftGroup> groups;
  for (const BodyPart& part : body.parts) {
    const LoftEnd a{frames[part.joint] * part.from, part.radius},
        b{frames[part.joint] * part.to, part.radius};
    groups.push_back(
        {{{a, b, Vector3d::UnitY(), {part.joint, part.joint}, 1e-3, kShirt}}, 1e-3, {}});
  }
  return groups;
}

}  // namespace amble
