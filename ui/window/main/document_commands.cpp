#include "ui/window/main/document_commands.h"

#include <QDir>
#include <QFileInfo>
#include <QLocale>
#include <QMenu>
#include <QSettings>
#include <filesystem>

#include "core/base/atomic_file.h"
#include "core/lesson/lesson_file.h"
#include "core/lesson/lesson_results.h"
#include "core/scene/provenance.h"
#include "core/scene/scene_demands.h"
#include "core/scene/scene_file.h"
#include "core/scene/scene_files.h"
#include "ui/language/language.h"
#include "ui/language/translated.h"
#include "ui/panels/controls.h"
#include "ui/panels/parameter_panel.h"
#include "ui/panels/parameter_text.h"
#include "ui/window/main/commands.h"
#include "ui/window/main/file_dialogs.h"
#include "ui/window/main/message_bar.h"

namespace asperity {

namespace {

const QString kRecentFiles = QStringLiteral("recentFiles");

}  // namespace

DocumentCommands::DocumentCommands(SceneDocument& document, const ParameterPanel& panel,
                                   MessageBar& messages, QWidget& window)
    : QObject(&window), document_(document), panel_(panel), messages_(messages), window_(window) {
  // A file that is still being read was requested before this document.
  connect(&document_, &SceneDocument::opening, this, [this] { reading_.cancel(); });
}

void DocumentCommands::addTo(Commands& commands) {
  commands_ = &commands;
  commands.add({"open",
                [] { return tr("Open scene…"); },
                [this] { askOpen(); },
                {QKeySequence::Open},
                Symbol::Open});
  commands.add({"save",
                [] { return tr("Save scene"); },
                [this] { save(); },
                {QKeySequence::Save},
                Symbol::Save,
                [] { return tr("Save"); }});
  commands.add({"saveAs",
                [] { return tr("Save scene as…"); },
                [this] { askSave(); },
                {Qt::CTRL | Qt::SHIFT | Qt::Key_S}});
  commands.add({"undo",
                [this] {
                  const QUndoStack& history = document_.history();
                  return history.canUndo() ? tr("Undo %1").arg(history.undoText()) : tr("Undo");
                },
                [this] { document_.history().undo(); },
                {QKeySequence::Undo},
                Symbol::Undo,
                [] { return tr("Undo"); }});
  QList<QKeySequence> redoKeys = QKeySequence::keyBindings(QKeySequence::Redo);
  if (const QKeySequence y(Qt::CTRL | Qt::Key_Y); !redoKeys.contains(y)) redoKeys += y;
  commands.add({"redo",
                [this] {
                  const QUndoStack& history = document_.history();
                  return history.canRedo() ? tr("Redo %1").arg(history.redoText()) : tr("Redo");
                },
                [this] { document_.history().redo(); }, redoKeys, Symbol::Redo,
                [] { return tr("Redo"); }});
  commands.add(
      {"revert", [] { return tr("Revert to the opened scene"); }, [this] { document_.revert(); }});
  commands.add(
      {"resetAll", [] { return tr("Reset all parameters"); }, [this] { document_.resetAll(); }});
  // The list of shortcuts shows the general meaning of a key, without the name of the next step.
  keepTranslated(*this, [&commands] {
    commands.get("undo")->setProperty("shortText", tr("Undo"));
    commands.get("redo")->setProperty("shortText", tr("Redo"));
  });
  connect(&document_, &SceneDocument::historyChanged, this, &DocumentCommands::showHistory);
  showHistory();
}

void DocumentCommands::showHistory() {
  commands_->refresh("undo");
  commands_->refresh("redo");
  commands_->get("undo")->setEnabled(document_.history().canUndo());
  commands_->get("redo")->setEnabled(document_.history().canRedo());
  commands_->get("revert")->setEnabled(document_.isChanged());
}

// ---- Opening

void DocumentCommands::askOpen() {
  const QString file = askOpenFile(
      &window_, tr("Open scene"), proposedFolder(document_.file()),
      tr("Scenes, and what was made from one (*.json *.png *.svg *.pdf *.csv *.mp4 *.webm *.gif "
         "*.webp);;Scenes (*.json);;All files (*)"));
  if (!file.isEmpty()) openFile(file);
}

void DocumentCommands::openFile(const QString& file) {
  if (isLessonFile(file.toStdString()) || isResultsFile(file.toStdString())) {
    reading_.cancel();
    emit lessonFound(file);
    return;
  }
  reading_.request([file](const BackgroundWork::Run&) { return findScene(file.toStdString()); },
                   [this, file](const FoundScene& found) { showFound(file, found); },
                   messages_.failureReporter(MessageBar::Failure::Files));
}

void DocumentCommands::showFound(const QString& file, const FoundScene& found) {
  if (!confirmOpen(file, found)) return;
  // A scene that was opened from a picture must not be saved over the picture.
  document_.open({{}, found.isEmbedded ? QString() : file, found.scene});
  addRecentFile(file);
  fillRecent();
}

/// Asks a question where a scene, which another user may have put into a file, reads other files or
/// needs much memory or time.
bool DocumentCommands::confirmOpen(const QString& file, const FoundScene& found) {
  const SceneDemands demands = found.isEmbedded ? sceneDemands(found.scene) : SceneDemands{};
  if (!demands.any()) return true;
  QStringList reasons;
  if (!demands.file.empty())
    reasons += tr("It reads a file from another folder: %1")
                   .arg(QDir::toNativeSeparators(QString::fromStdString(demands.file.string())));
  if (demands.memory > 0)
    reasons +=
        tr("It takes about %1 GB of memory.").arg(QLocale().toString(demands.memory / 1e9, 'f', 1));
  if (demands.seconds > 0)
    reasons += tr("Its curve takes about %1 minutes of processor time.")
                   .arg(QLocale().toString(demands.seconds / 60, 'g', 2));
  const Question question{
      "demandQuestion",
      tr("Asperity"),
      tr("Open the scene in “%1”?").arg(QFileInfo(file).fileName()) + "\n\n" + reasons.join('\n'),
      {},
      QMessageBox::Warning};
  return ask(&window_, question,
             {{QMessageBox::Open, tr("&Open")}, {QMessageBox::Cancel, tr("&Cancel")}},
             QMessageBox::Cancel) == QMessageBox::Open;
}

// ---- Saving

bool DocumentCommands::saveTo(const QString& file) {
  if (!missingValue(panel_.scene()).text.isEmpty()) {
    messages_.showFailure(MessageBar::Failure::Files, [scene = panel_.scene()] {
      const Missing missing = missingValue(scene);
      return labelText(*findParameter(missing.key)) + ": " + missing.text;
    });
    return false;
  }
  if (!write(file, document_.scene())) return false;
  document_.saved(file);
  addRecentFile(file);
  fillRecent();
  emit saved(file);
  return true;
}

bool DocumentCommands::write(const QString& file, const Scene& scene) {
  return messages_.succeeds(MessageBar::Failure::Files, [&] {
    const std::filesystem::path path = std::filesystem::absolute(file.toStdString());
    writeFileAtomically(path, writeScene(withFilesRelativeTo(path.parent_path(), scene)));
  });
}

bool DocumentCommands::save() {
  return document_.file().isEmpty() ? askSave() : saveTo(document_.file());
}

bool DocumentCommands::askSave() {
  const QString file =
      askSaveFile(&window_, tr("Save scene"), document_.fileOrProposal(), tr("Scenes (*.json)"));
  return !file.isEmpty() && saveTo(file);
}

bool DocumentCommands::canClose() {
  document_.endTrial();
  for (const SceneState& state : document_.unsavedFiles())
    if (!maybeSave(state)) return false;
  return true;
}

/// Asks whether the changes of a file are to be saved, and saves them.
bool DocumentCommands::maybeSave(const SceneState& state) {
  const bool isPresent = state.origin.file == document_.file();
  const QString file = QFileInfo(state.origin.file).absoluteFilePath();
  QString name = sceneText(state.scene.title);
  if (name.isEmpty()) name = QFileInfo(file).fileName();
  switch (askSaveChanges(&window_, "saveQuestion", tr("Asperity"),
                         tr("“%1” was changed. Save the changes?").arg(name),
                         tr("They are saved in %1.").arg(QDir::toNativeSeparators(file)) + ' ' +
                             tr("Otherwise they are lost."))) {
    case QMessageBox::Save:
      return isPresent ? saveTo(state.origin.file) : write(file, state.scene);
    case QMessageBox::Discard:
      if (isPresent) document_.revert();
      return true;
    default:
      return false;
  }
}

// ---- Recent files

void DocumentCommands::addRecentMenu(QMenu& menu) {
  recent_ = addSubmenu(menu, "recentMenu", [] { return tr("Open recent"); });
  recent_->setToolTipsVisible(true);
  connect(&menu, &QMenu::aboutToShow, this, &DocumentCommands::fillRecent);
  keepTranslated(*recent_, [this] { fillRecent(); });
}

/// Fills the menu. Files of the same name differ in their tooltips.
void DocumentCommands::fillRecent() {
  recent_->clear();
  const QStringList files = recentFiles();
  for (const QString& file : files) {
    QAction* action = recent_->addAction(QFileInfo(file).fileName().replace('&', "&&"), this,
                                         [this, file] { openFile(file); });
    action->setToolTip(file);
  }
  if (files.isEmpty()) return explainEmpty(*recent_, tr("No scene was opened or saved yet"));
  recent_->addSeparator();
  recent_->addAction(tr("Clear this list"), this, [this] {
    clearRecentFiles();
    fillRecent();
  });
}

QStringList recentFiles() {
  QStringList files = QSettings().value(kRecentFiles).toStringList();
  files.removeIf([](const QString& file) { return !QFileInfo::exists(file); });
  return files;
}

void addRecentFile(const QString& file) {
  const QString path = QFileInfo(file).absoluteFilePath();
  QStringList files = recentFiles();
  files.removeAll(path);
  files.prepend(path);
  QSettings().setValue(kRecentFiles, files.mid(0, kMaxRecentFiles));
}

void clearRecentFiles() {
  QSettings().remove(kRecentFiles);
}

}  // namespace asperity
