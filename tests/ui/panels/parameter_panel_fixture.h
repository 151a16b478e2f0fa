// The panel of parameters alone, and a person's hands on it. For tests on the GUI thread.
#pragma once

#include <gtest/gtest.h>

#include <QComboBox>
#include <QLabel>
#include <QSignalSpy>
#include <QTest>
#include <string>
#include <variant>
#include <vector>

#include "core/scene/parameters.h"
#include "ui/panels/number_text.h"
#include "ui/panels/parameter_panel.h"
#include "ui/panels/value_entry.h"
#include "ui/panels/value_slider.h"

namespace asperity {

/// One scene for each word of each choice of the table: each row has a meaning for one of them.
inline std::vector<Scene> scenesOfEveryKind() {
  std::vector<Scene> scenes;
  for (const Parameter& kind : parameters()) {
    const auto* field = std::get_if<ChoiceField>(&kind.field);
    if (!field) continue;
    for (const std::string_view word : field->choices)
      setValue(kind, scenes.emplace_back(), std::string(word));
  }
  return scenes;
}

class ParameterPanelTest : public testing::Test {
 protected:
  ParameterPanelTest() : spy_(&panel_, &ParameterPanel::sceneEdited) {
    panel_.setView({true, {}});  // all rows
    panel_.resize(380, 700);
    panel_.show();
  }

  template <class Control>
  Control* control(const QString& name) {
    return panel_.findChild<Control*>(name);
  }
  ValueSlider& slider(const QString& key) { return *control<ValueSlider>("slider:" + key); }
  ValueEntry& entry(const QString& key) { return *control<ValueEntry>("entry:" + key); }
  /// The remark of this kind below a row; empty where there never was one.
  QString remark(const QString& kind, const QString& key) {
    EXPECT_NE(findParameter(key.toStdString()), nullptr) << key.toStdString();
    const auto* label = control<QLabel>(kind + ":" + key);
    return label ? label->text() : QString();
  }
  /// With plain blanks where the label has those that break no line.
  QString complaint(const QString& key) { return remark("error", key).replace(QChar::Nbsp, ' '); }

  bool isShown(const QString& name) {
    auto* widget = control<QWidget>(name);
    return widget && widget->isVisibleTo(&panel_);
  }

  void type(const QString& key, const QString& text) {
    entry(key).setFocus();
    entry(key).selectAll();
    QTest::keyClick(&entry(key), Qt::Key_Delete);
    QTest::keyClicks(&entry(key), text);
    QTest::keyClick(&entry(key), Qt::Key_Return);
  }

  void choose(const QString& key, const QString& word) {
    auto* box = control<QComboBox>("choice:" + key);
    box->setCurrentIndex(box->findData(word));
    emit box->activated(box->currentIndex());
  }

  ParameterPanel panel_{Scene{}};
  QSignalSpy spy_;
};

}  // namespace asperity
