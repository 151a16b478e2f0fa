#include "ui/window/contact/contact_tips.h"

#include "core/scene/parameters.h"
#include "ui/language/translated.h"
#include "ui/panels/number_text.h"
#include "ui/panels/parameter_text.h"
#include "ui/window/contact/contact_canvas.h"

namespace asperity {

QString dragHint(ContactHandle handle, const Scene& scene) {
  if (handle == ContactHandle::Velocity && scene.sliding.kind == SlidingKind::Oscillation)
    return ContactCanvas::tr(
        "Drag to the right for a larger velocity amplitude, to the left for a smaller one.");
  if (handle == ContactHandle::Velocity)
    return ContactCanvas::tr("Drag to the right to slide faster, to the left to slide slower.");
  if (handle == ContactHandle::Force)
    return ContactCanvas::tr("Drag down to press harder, up to press less.");
  return scene.load.kind == LoadKind::Indentation
             ? ContactCanvas::tr(
                   "Drag the body down into the elastomer or up; sideways moves a "
                   "zoomed view.")
             : ContactCanvas::tr(
                   "Drag down to press harder, up to press less; sideways moves a "
                   "zoomed view.");
}

namespace {

/// Returns the explanation of a sign for the elements of the scene, or its text where it has none.
ContactTip signTip(const ContactSign& sign, Rheology rheology) {
  const QString sentence = keptTogether(QString::fromStdString(sign.tip));
  // The words beside the arrow of the velocity say what the line does, not what the arrow is.
  const Parameter* parameter =
      sign.handle == ContactHandle::Velocity ? findParameter(sign.id) : nullptr;
  const QString title = parameter ? labelText(*parameter) : QString::fromStdString(sign.name);
  const auto explanation = findExplanation(sign.id);
  if (!explanation) return {wrappedTip(sentence), {}};
  return {explanationHtml(withFormulaFor(*explanation, rheology), title, sentence),
          anchorText(*explanation)};
}

}  // namespace

QString draggedText(ContactHandle handle, const Scene& scene) {
  const Parameter parameter = parameterIn(knownParameter(draggedKey(handle, scene)), scene);
  const double value = std::get<double>(parameterValue(parameter, scene));
  return labelText(parameter) + ": " + quantityLabel(value, parameter.unit, 4);
}

ContactHandle contactHandleAt(const Frame& frame, const ContactPictureOptions& options,
                              const QPointF& pixel, const std::optional<Scene>& scene) {
  if (!scene) return ContactHandle::None;
  const ContactHandle handle =
      handleAt(frame, options, static_cast<float>(pixel.x()), static_cast<float>(pixel.y()));
  return draggedKey(handle, *scene).empty() ? ContactHandle::None : handle;
}

ContactTip contactTipAt(const Frame& frame, const ContactPictureOptions& options,
                        const QPointF& pixel, const std::optional<Scene>& scene) {
  ContactTip tip;
  if (const auto sign = contactSignAt(frame, options, static_cast<float>(pixel.x()),
                                      static_cast<float>(pixel.y()))) {
    tip = signTip(*sign, frame.scene->elastomer.rheology);
    tip.explained = {sign->box.x, sign->box.y, sign->box.width, sign->box.height};
  }
  if (const ContactHandle handle = contactHandleAt(frame, options, pixel, scene);
      handle != ContactHandle::None)
    tip.html += wrappedTip(dragHint(handle, *scene)) + wrappedTip(draggedText(handle, *scene));
  return tip;
}

}  // namespace asperity
