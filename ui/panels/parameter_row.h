// One row of the table of parameters as controls: label with symbol, then slider and exact entry,
// or a list of words, or a text; the sentence and the allowed range as tooltip, a button back to
// the default, and the reason beneath where a text is refused. Object names: "slider:KEY",
// "entry:KEY", "choice:KEY", "reset:KEY", "error:KEY", "row:KEY". The row holds no scene; it shows
// one and says what a person gave. GUI thread.
#pragma once

#include <QWidget>

#include "core/scene/parameters.h"

class QHBoxLayout;
class QLabel;
class QToolButton;

namespace asperity {

class ChoiceBox;
class ValueEntry;
class ValueSlider;

class ParameterRow : public QWidget {
  Q_OBJECT

 public:
  /// `heading`, where not empty, stands for the row's own label as the title of its section.
  ParameterRow(const Parameter& parameter, const QString& heading, QWidget* parent = nullptr);

  const Parameter& parameter() const { return parameter_; }

  /// Shows the scene's value and vanishes where the row does not apply. `replace` also overwrites
  /// what someone typed and was refused.
  void showScene(const Scene& scene, bool replace);
  void showError(const QString& reason);

 signals:
  void valueGiven(const asperity::ParameterValue& value);
  void textGiven(const QString& text);

 protected:
  void contextMenuEvent(QContextMenuEvent* event) override;

 private:
  void addLabel(QHBoxLayout& line, const QString& heading);
  void addNumber(QHBoxLayout& line);
  void addChoice(QHBoxLayout& line, const ChoiceField& field);
  void addText(QHBoxLayout& line);
  void addReset(QHBoxLayout& line);
  void describe(QWidget& control, const char* kind);
  QString description() const;

  const Parameter& parameter_;
  ValueSlider* slider_ = nullptr;
  ValueEntry* entry_ = nullptr;
  ChoiceBox* choice_ = nullptr;
  QToolButton* reset_ = nullptr;
  QLabel* error_ = nullptr;
};

}  // namespace asperity
