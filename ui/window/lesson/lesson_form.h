// A page of the lesson editor: rows of labels and fields, in one language at a time. It emits a
// signal when the user edits, but not while it is filled. GUI thread; owned by its parent.
#pragma once

#include <QString>
#include <QWidget>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/lesson/lesson.h"

class QComboBox;
class QFormLayout;
class QLineEdit;
class QMenu;
class QPlainTextEdit;
class QToolButton;
class QVBoxLayout;

namespace asperity {

struct Parameter;

/// Changes of a scene, which a lesson's file writes as KEY=VALUE: a row for each, with the label of
/// the parameter and its value as the panel shows it, and a button that adds another one. A change
/// stays as it is written in the file until its row is edited.
class AssignmentList : public QWidget {
  Q_OBJECT

 public:
  /// The rows are named NAME:KEY, the button that adds one NAME. label: of the list, by which
  /// screen readers tell its button from those of other lists.
  AssignmentList(const QString& name, const QString& label, QWidget* parent = nullptr);

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

class LessonForm : public QWidget {
  Q_OBJECT

 public:
  explicit LessonForm(QWidget* parent = nullptr);

  /// Sets the language of the texts; what is shown follows with the next lesson or step.
  void setGerman(bool isGerman) { isGerman_ = isGerman; }

  // Rows. The name is that of the object, the label also that for screen readers.
  QLineEdit* addLine(const QString& label, const char* name);
  QPlainTextEdit* addText(const QString& label, const char* name, int lines);
  QComboBox* addChoice(const QString& label, const char* name);
  AssignmentList* addAssignments(const QString& label, const char* name);
  void addRow(const QString& label, QWidget* field);
  /// Shows or hides a field with its label.
  void setShown(QWidget* field, bool isShown);

  /// Fills fields without emitting a signal.
  template <class Fill>
  void fill(const Fill& fields) {
    isFilling_ = true;
    fields();
    isFilling_ = false;
  }
  /// Emits edited(), unless the page is being filled.
  void notifyEdited();

  QString localText(const LessonText& text) const;
  /// Shows a text from its beginning. Where it lacks the language of the page, the other one is the
  /// placeholder; `hint` is that of a field without any text.
  void showText(QLineEdit& line, const LessonText& text, const QString& hint = {}) const;
  void showText(QPlainTextEdit& box, const LessonText& text, const QString& hint = {}) const;
  /// Returns that placeholder.
  QString placeholder(const LessonText& text, const QString& hint = {}) const;
  /// Returns the text of a box with its no-break spaces, which QPlainTextEdit::toPlainText()
  /// replaces by spaces.
  static QString plainText(const QPlainTextEdit& box);
  void write(LessonText& text, const QString& written) const;
  void write(LessonText& text, const QString& written, const QString& inOtherLanguage) const;

 signals:
  void edited();

 private:
  QFormLayout* rows_;
  bool isGerman_ = false, isFilling_ = false;
};

/// Fills a menu with a submenu for each section of the panel. `add` adds entries for a parameter
/// that has a meaning in the scene; a submenu without entries is left out.
void fillParameterMenu(QMenu& menu, const Scene& scene,
                       const std::function<void(QMenu& section, const Parameter& row)>& add);

/// Returns the number in a text as people type it in the current language; nothing where there is
/// none.
std::optional<double> numberIn(const QString& text);

/// Returns a part as a number of per cent.
QString percentText(double part);
/// Returns the part that a text gives in per cent. Where it was not edited, or is no number, it is
/// the one before with all its digits.
double partIn(const QString& text, double before);

/// Returns a parameter's value with its unit, as in "5 \u00B5m/s".
QString keyValueText(const std::string& key, double value);
/// Reads such a text; a number without a unit is in SI. Returns nothing where there is no number.
std::optional<double> parseKeyValue(const std::string& key, const QString& text);

}  // namespace asperity
