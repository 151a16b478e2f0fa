// The tips of the picture of the contact: the explanation of the text or symbol under the pointer
// (ui/contact/contact_signs.h), with its formula and its anchor in the guide, and what a drag from
// here changes. GUI thread.
#pragma once

#include <QPointF>
#include <QRectF>
#include <QString>
#include <optional>

#include "ui/contact/contact_picture.h"
#include "ui/contact/contact_signs.h"

namespace asperity {

struct ContactTip {
  QString html;         // rich text; empty: no tip here
  QString guideAnchor;  // empty: nothing is explained here
  QRectF explained{};   // the text or symbol, in pixels of the picture; empty: none
};

/// Returns the tip at a pixel of the picture. scene: what drags change; none: they move the view.
ContactTip contactTipAt(const Frame& frame, const ContactPictureOptions& options,
                        const QPointF& pixel, const std::optional<Scene>& scene);

/// Returns what a drag from a pixel would change.
ContactHandle contactHandleAt(const Frame& frame, const ContactPictureOptions& options,
                              const QPointF& pixel, const std::optional<Scene>& scene);

/// Returns one sentence on what a drag of this handle does.
QString dragHint(ContactHandle handle, const Scene& scene);

/// Returns "normal force: 200 mN", the value that a drag changes.
QString draggedText(ContactHandle handle, const Scene& scene);

}  // namespace asperity
