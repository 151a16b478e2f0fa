// Changes of a scene, which a lesson's file writes as KEY=VALUE: a row for each, with the label of
// the parameter and its value as the panel shows it, and a button that adds another one. A change
// stays as it is written in the file until its row is edited. GUI thread;
// owned by its parent.
#pragma once

#include <QWidget>
#include <string>
#include <vector>

#include "core/scene/scene.h"

class QToolButton;
class QVBoxLayout;

namespace asperity {

struct Parameter;

class AssignmentList : public QWidget {
  Q_OBJECT

 public:
  /// The rows are named NAME:KEY, the button that adds one NAME.
  explicit AssignmentList(const QString& name, QWidget* parent = nullptr);

  /// Shows changes of this scene, which may have them already.
  void show(const std::vector<std::string>& assignments, const Scene& scene);
  const std::vector<std::string>& assignments() const { return assignments_; }

 signals:
  void edited();

 private:
  void showRows();
  QWidget* makeRow(std::size_t index);
  QWidget* makeValue(std::size_t index, const Parameter& row);
  void write(std::size_t index, const QString& value);
  void remove(std::size_t index);
  void add(const Parameter& row);
  void fillMenu();
  Scene changed() const;

  QString name_;
  std::vector<std::string> assignments_;
  Scene scene_;
  QVBoxLayout* column_;
  QWidget* rows_ = nullptr;
  QToolButton* add_;
};

}  // namespace asperity
