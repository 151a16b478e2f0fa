#include "ui/window/gallery/scene_cards.h"

#include <QCoreApplication>
#include <algorithm>
#include <array>

namespace asperity {

namespace {

struct SceneCardText {
  Q_DECLARE_TR_FUNCTIONS(asperity::SceneCardText)

 public:
  static std::span<const SceneCard> cards() {
    static constexpr std::array kCards{
        SceneCard{"figure_1", SceneView::Contact,
                  QT_TR_NOOP("Only the highest summits touch, and the rubber comes back late "
                             "behind each of them.")},
        SceneCard{
            "figure_2", SceneView::Curve,
            QT_TR_NOOP("Friction grows with the velocity, bends into a plateau and falls again.")},
        SceneCard{
            "one_sided", SceneView::Contact,
            QT_TR_NOOP(
                "The rubber presses on the front of the summit and is not back yet behind it.")},
        SceneCard{"pressed", SceneView::CloseUp,
                  QT_TR_NOOP("Nothing slides: contact is even on both sides of each summit, and "
                             "there is no friction.")},
        SceneCard{"region_1", SceneView::CloseUp,
                  QT_TR_NOOP("Slow: both sides of each summit touch, and friction doubles when "
                             "the velocity doubles.")},
        SceneCard{"region_2", SceneView::CloseUp,
                  QT_TR_NOOP("Contact begins to leave the rear sides of the summits, and the "
                             "straight line bends.")},
        SceneCard{
            "region_3", SceneView::CloseUp,
            QT_TR_NOOP(
                "Only front sides touch: friction hardly depends on velocity, modulus or force.")},
        SceneCard{
            "region_4", SceneView::CloseUp,
            QT_TR_NOOP(
                "A few tips carry everything, and friction falls although sliding is faster.")},
        SceneCard{
            "parabola", SceneView::CloseUp,
            QT_TR_NOOP("Contact moves to the front of the summit when you raise the velocity.")},
        SceneCard{"roll_off", SceneView::Contact,
                  QT_TR_NOOP("Many summits of one size instead of a landscape: a steeper line has "
                             "more friction.")},
        SceneCard{
            "rough_summits", SceneView::CloseUp,
            QT_TR_NOOP("Fine roughness on the summits counts at once, even under a light load.")},
        SceneCard{"rough_valleys", SceneView::CloseUp,
                  QT_TR_NOOP("Fine roughness in the valleys counts only when the load presses "
                             "the rubber into them.")},
        SceneCard{
            "wedge", SceneView::CloseUp,
            QT_TR_NOOP(
                "Raise the velocity: friction reaches the slope of the flank and stays there.")},
        SceneCard{
            "elastic", SceneView::Contact,
            QT_TR_NOOP(
                "Without memory the rubber gives back what it took: no friction at any velocity.")},
        SceneCard{"interface_friction", SceneView::Curve,
                  QT_TR_NOOP(
                      "A constant share of the interface is added to what the deformation costs.")},
        SceneCard{
            "interface_shear", SceneView::Curve,
            QT_TR_NOOP(
                "One share falls with the contact while the other rises: find where they cross.")},
        SceneCard{"prony_dashpot", SceneView::Curve,
                  QT_TR_NOOP("Each arm of the rubber makes a shoulder in the friction curve.")},
        SceneCard{"standard_solid", SceneView::Curve,
                  QT_TR_NOOP("One arm makes one broad peak: fast rubber is as elastic as slow "
                             "rubber, only stiffer.")},
        SceneCard{
            "temperature_cold", SceneView::Curve,
            QT_TR_NOOP(
                "Cold rubber has its friction at lower velocities; the shape of the curve stays.")},
        SceneCard{"temperature_tread", SceneView::Curve,
                  QT_TR_NOOP("Move the temperature: the whole curve slides along the velocity.")},
        SceneCard{"temperature_warm", SceneView::Curve,
                  QT_TR_NOOP("Warm rubber needs a higher velocity for the same friction.")},
        SceneCard{
            "tread_compound", SceneView::Curve,
            QT_TR_NOOP("Thirteen arms spread the rise of friction over ten decades of velocity.")},
        SceneCard{
            "wedge_standard_solid", SceneView::Curve,
            QT_TR_NOOP(
                "Friction vanishes for slow and for fast sliding: there the rubber is elastic.")},
        SceneCard{"oscillation", SceneView::Motion,
                  QT_TR_NOOP("At the same velocity, friction on the way up differs from friction "
                             "on the way down.")},
        SceneCard{"reversal", SceneView::Motion,
                  QT_TR_NOOP("The line turns back into its own dents: friction is first too small, "
                             "then settles.")},
        SceneCard{
            "start", SceneView::Motion,
            QT_TR_NOOP(
                "Friction begins above its steady value and settles while the line is lifted.")},
        SceneCard{
            "start_standard_solid", SceneView::Motion,
            QT_TR_NOOP(
                "Friction shoots to more than twice its steady value before the rubber relaxes.")},
        SceneCard{
            "stop", SceneView::Motion,
            QT_TR_NOOP(
                "The line stops at half time, but the force needs a relaxation time to vanish.")},
        SceneCard{"velocity_step", SceneView::Motion,
                  QT_TR_NOOP("At twice the velocity friction first jumps and then relaxes.")},
        SceneCard{"velocity_step_parabola", SceneView::Motion,
                  QT_TR_NOOP("A single contact relaxes along one exponential curve.")},
        SceneCard{
            "foundation_and_half_space", SceneView::Curve,
            QT_TR_NOOP(
                "Two models of the same rubber: see where they agree and where they do not.")},
        SceneCard{"full_contact", SceneView::Contact,
                  QT_TR_NOOP("The rubber fills every valley, and friction is known exactly.")},
        SceneCard{
            "full_contact_sine", SceneView::Curve,
            QT_TR_NOOP("The friction curve of a single wave is the loss modulus of the rubber.")},
        SceneCard{
            "rubber_on_sandpaper", SceneView::CloseUp,
            QT_TR_NOOP("Raise the velocity and watch the rubber leave the rear of each grain.")},
        SceneCard{
            "shoe_on_concrete", SceneView::Curve,
            QT_TR_NOOP(
                "Beyond the maximum, a foot that begins to slip has less and less friction.")},
        SceneCard{
            "tyre_on_asphalt", SceneView::Contact,
            QT_TR_NOOP("Each stone is touched on its front only: that is the friction of a tyre.")},
    };
    return kCards;
  }
};

}  // namespace

std::span<const SceneCard> sceneCards() {
  return SceneCardText::cards();
}

const SceneCard* findCard(const QString& scene) {
  const auto cards = sceneCards();
  const auto found = std::ranges::find_if(
      cards, [&](const SceneCard& card) { return scene == QLatin1String(card.scene); });
  return found == cards.end() ? nullptr : &*found;
}

QString cardSentence(const SceneCard& card) {
  return SceneCardText::tr(card.sentence);
}

}  // namespace asperity
