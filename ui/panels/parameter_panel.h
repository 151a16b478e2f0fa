// The panel of parameters, generated from the table alone: one ParameterRow for each row, grouped
// by section, in a scroll area. Owns the scene that its controls show; every accepted change is a
// new scene. A refused text changes nothing and is explained where it was typed. GUI thread.
#pragma once

#include <QMap>
#include <QWidget>

#include "core/scene/scene.h"

class QVBoxLayout;

namespace asperity {

class ParameterRow;
struct Parameter;

class ParameterPanel : public QWidget {
  Q_OBJECT

 public:
  explicit ParameterPanel(const Scene& scene, QWidget* parent = nullptr);

  const Scene& scene() const { return scene_; }

  /// Shows another scene; emits nothing.
  void setScene(const Scene& scene);

  /// A complaint about a parameter that only came up when the scene ran. Unknown keys are ignored.
  void showError(const QString& key, const QString& text);

  QSize sizeHint() const override;

 signals:
  void sceneEdited(const asperity::Scene& scene);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void addSection(QVBoxLayout& column, const QString& section);
  void addRow(QVBoxLayout& column, const Parameter& parameter, const QString& heading);
  template <class Change>
  void edit(ParameterRow& row, Change&& change);
  void showRows(const ParameterRow* edited);
  void applyStyle();

  Scene scene_;
  QMap<QString, ParameterRow*> rows_;  // by key
};

}  // namespace asperity
