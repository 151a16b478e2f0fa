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

namespace asperity {

class AssignmentList;
struct Parameter;

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
  /// Adds a row below that of another field.
  void addRowBelow(QWidget* above, const QString& label, QWidget* field);
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

/// Returns the number in a text with a decimal point and no marks between its thousands; nothing
/// where there is none.
std::optional<double> plainNumberIn(const QString& text);
/// Returns the number in a text as people type it in the current language; nothing where there is
/// none.
std::optional<double> numberIn(const QString& text);

}  // namespace asperity
