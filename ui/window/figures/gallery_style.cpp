#include "ui/window/figures/gallery_style.h"

#include <QPalette>

namespace asperity {

QString galleryStyleSheet(const QPalette& palette) {
  const auto name = [&](QPalette::ColorRole role) { return palette.color(role).name(); };
  const auto tint = [&](int percent) {
    const QColor accent = palette.color(QPalette::Highlight);
    return QStringLiteral("rgba(%1, %2, %3, %4%)")
        .arg(accent.red())
        .arg(accent.green())
        .arg(accent.blue())
        .arg(percent);
  };
  return QStringLiteral(R"(
    #galleryBar { background: %1; border-top: 1px solid %3; }
    #galleryNote { color: %6; }
    QPushButton { background: %5; color: %2; border: 1px solid %3; border-radius: 6px;
                  padding: 5px 12px; }
    QPushButton:hover, QPushButton:focus { border-color: %4; }
    QPushButton:pressed { background: %3; }
    QPushButton:disabled { background: transparent; color: %6; }
    QProgressBar { background: %5; color: %2; border: 1px solid %3; border-radius: 6px;
                   text-align: center; min-height: 26px; }
    QProgressBar::chunk { background: %7; border-radius: 5px; }
    QTableWidget { selection-background-color: %8; }
    QHeaderView { background: %1; border: none; }
    QHeaderView::section { background: %1; color: %6; border: none;
                           border-bottom: 1px solid %3; padding: 5px 8px; }
  )")
      .arg(name(QPalette::Window), name(QPalette::WindowText), name(QPalette::Mid),
           name(QPalette::Highlight), name(QPalette::Base), name(QPalette::PlaceholderText),
           tint(35), tint(18));
}

}  // namespace asperity
