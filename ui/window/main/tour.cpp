#include "ui/window/main/tour.h"

#include <QCoreApplication>
#include <array>

namespace asperity {

namespace {

constexpr const char* kContext = "asperity::Tour";

constexpr std::array kSteps{
    TourStep{"pressed", QT_TRANSLATE_NOOP("asperity::Tour", "Press"),
             QT_TRANSLATE_NOOP("asperity::Tour",
                               "A rough line rests on rubber: only its highest summits touch."),
             QT_TRANSLATE_NOOP("asperity::Tour",
                               "Drag the normal force up: contacts grow in number and length.")},
    TourStep{"region_1", QT_TRANSLATE_NOOP("asperity::Tour", "Slide slowly"),
             QT_TRANSLATE_NOOP("asperity::Tour",
                               "The rubber has time to come back behind every summit, and friction "
                               "grows in proportion to the velocity."),
             QT_TRANSLATE_NOOP("asperity::Tour",
                               "Double the velocity: the coefficient of friction doubles.")},
    TourStep{"region_3", QT_TRANSLATE_NOOP("asperity::Tour", "The plateau"),
             QT_TRANSLATE_NOOP("asperity::Tour",
                               "Faster, friction stops growing: it is now set by the slope of the "
                               "line, not by the rubber."),
             QT_TRANSLATE_NOOP("asperity::Tour",
                               "Change the shear modulus or the force: the plateau stays.")},
    TourStep{"one_sided", QT_TRANSLATE_NOOP("asperity::Tour", "One-sided contact"),
             QT_TRANSLATE_NOOP("asperity::Tour",
                               "A single summit shows why: the rubber is too slow to touch its "
                               "trailing side, so it pushes only from the front."),
             QT_TRANSLATE_NOOP("asperity::Tour",
                               "Lower the velocity to 0.001 m/s: contact becomes even on both "
                               "sides, and friction vanishes.")},
    TourStep{"region_4", QT_TRANSLATE_NOOP("asperity::Tour", "Region IV"),
             QT_TRANSLATE_NOOP("asperity::Tour",
                               "Faster still, only the tips of the highest summits touch, and they "
                               "are smooth: friction falls again."),
             QT_TRANSLATE_NOOP("asperity::Tour",
                               "Raise the elements: finer tips move the fall to higher "
                               "velocities.")},
    TourStep{"full_contact", QT_TRANSLATE_NOOP("asperity::Tour", "Full contact"),
             QT_TRANSLATE_NOOP("asperity::Tour",
                               "Under a high load the rubber fills every valley, and friction is "
                               "known exactly."),
             QT_TRANSLATE_NOOP("asperity::Tour",
                               "Raise the velocity until the first valleys open: there the "
                               "straight line ends.")},
};

}  // namespace

std::span<const TourStep> tourSteps() {
  return kSteps;
}

QString tourText(const char* text) {
  return QCoreApplication::translate(kContext, text);
}

}  // namespace asperity
