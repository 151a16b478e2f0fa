#include "ui/window/import/import_commands.h"

#include <QAction>
#include <QFileInfo>
#include <algorithm>
#include <exception>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>

#include "core/base/embedded_provenance.h"
#include "core/base/input_error.h"
#include "core/base/json_text.h"
#include "core/base/regular_file.h"
#include "core/base/text.h"
#include "core/base/text_number.h"
#include "core/base/text_table.h"
#include "core/fit/friction_data.h"
#include "core/material/dma_columns.h"
#include "core/material/material_library.h"
#include "core/material/prony_file.h"
#include "core/measured/measured_file.h"
#include "core/scene/scene_files.h"
#include "ui/draw/picture_file.h"
#include "ui/language/language.h"
#include "ui/language/translated.h"
#include "ui/panels/parameter_panel.h"
#include "ui/window/import/material_import.h"
#include "ui/window/import/surface_import.h"
#include "ui/window/main/commands.h"
#include "ui/window/main/document_commands.h"
#include "ui/window/main/file_dialogs.h"
#include "ui/window/main/message_bar.h"
#include "ui/window/main/scene_document.h"
#include "ui/window/main/scene_library.h"

namespace asperity {

// ---- The kind of a file

namespace {

constexpr std::size_t kBeginning = 64 << 10;                     // bytes
constexpr std::uint64_t kLargestTable = std::uint64_t{8} << 20;  // bytes of measured moduli

/// Pictures and films, which hold a scene or nothing that can be opened.
bool isPicture(const std::filesystem::path& file) {
  const std::string extension = lowerCase(file.extension().string());
  return isOneOf(extension, kPictureExtensions) ||
         isOneOf(extension, {".mp4", ".webm", ".gif", ".webp"});
}

bool isMaterialJson(std::string_view text) {
  const auto root = jsonOrDiscarded(text);
  return root.is_object() && root.contains("schema") && root["schema"] == kMaterialSchema;
}

/// Returns whether a table has columns of a modulus and of frequency or temperature, by their
/// names.
bool hasModuli(const TextTable& table) {
  for (const TextBlock& block : table.blocks) {
    bool hasState = false, hasModulus = false;
    for (const TextColumn& column : block.columns) {
      const DmaQuantity quantity = dmaColumn(column.name, column.unit).quantity;
      hasState = hasState || quantity == DmaQuantity::Frequency ||
                 quantity == DmaQuantity::ReducedFrequency || quantity == DmaQuantity::Temperature;
      hasModulus = hasModulus || quantity == DmaQuantity::Storage ||
                   quantity == DmaQuantity::Loss || quantity == DmaQuantity::Magnitude;
    }
    if (hasState && hasModulus) return true;
  }
  return false;
}

/// Returns the kind of a table of numbers; a table of no other kind is a surface.
FileKind kindOfText(const std::string& text) {
  try {
    if (readPronyFile(text, nullptr, "", {})) return FileKind::Moduli;
  } catch (const InputError&) {
    return FileKind::Moduli;  // a series with a fault, which its page explains
  }
  if (isFrictionTable(text)) return FileKind::Friction;
  std::optional<TextTable> table;
  try {
    TextTableOptions options;
    options.keepsTexts = options.readsCells = true;
    table = readTextTable(text, "", options);
  } catch (const InputError&) {
    return FileKind::Surface;
  }
  if (hasModuli(*table)) return FileKind::Moduli;
  try {
    return readPronyFile(text, &*table, "", {}) ? FileKind::Moduli : FileKind::Surface;
  } catch (const InputError&) {
    return FileKind::Moduli;
  }
}

}  // namespace

FileKind kindOfFile(const std::filesystem::path& file) {
  try {
    const RegularFile opened(file);
    const std::string beginning = opened.read(0, kBeginning);
    if (beginsAsObject(beginning)) {
      constexpr std::size_t kLargestMaterial = std::size_t{1} << 20;
      return isMaterialJson(opened.read(0, kLargestMaterial)) ? FileKind::Material
                                                              : FileKind::Scene;
    }
    if (isPicture(file) || beginsAsObject(embeddedProvenance(beginning))) return FileKind::Scene;
    const bool mayBeText = beginning.find('\0') == beginning.npos ||
                           beginning.starts_with("\xFF\xFE") || beginning.starts_with("\xFE\xFF");
    if (mayBeText && opened.size() <= kLargestTable)
      return kindOfText(opened.read(0, static_cast<std::size_t>(kLargestTable)));
    return FileKind::Surface;
  } catch (const InputError&) {
    return FileKind::Scene;
  }
}

// ---- The commands

ImportCommands::ImportCommands(const Parts& parts) : QObject(&parts.window), parts_(parts) {
  connect(&parts_.panel, &ParameterPanel::surfaceRequested, this, &ImportCommands::askSurface);
  connect(&parts_.panel, &ParameterPanel::materialRequested, this, &ImportCommands::askMaterial);
  connect(&parts_.panel, &ParameterPanel::frictionRequested, this, &ImportCommands::askFriction);
  connect(&parts_.document, &SceneDocument::opening, this, [this] { work_.cancel(); });
}

void ImportCommands::addTo(Commands& commands) {
  commands.add({"openSurface",
                [] { return tr("Open surface…"); },
                [this] { askSurface(parts_.document.scene()); },
                {Qt::CTRL | Qt::SHIFT | Qt::Key_O}});
  commands.add({"openMaterial", [] { return tr("Open material…"); }, [this] { askMaterial(); }});
  commands.add(
      {"openFriction", [] { return tr("Add measured friction…"); }, [this] { askFriction(); }});
}

/// The folder of the file of the scene's line, or where it has none that of the document.
QString ImportCommands::folder() const {
  const Scene& scene = parts_.document.scene();
  const QString line = QString::fromStdString((scene.folder / scene.surface.file).string());
  return proposedFolder(scene.surface.file.empty() ? parts_.document.file() : line);
}

void ImportCommands::askSurface(const Scene& scene) {
  QStringList patterns;
  for (const std::string_view ending : surfaceFileEndings()) patterns << "*." + fromUtf8(ending);
  const QString file =
      askOpenFile(&parts_.window, tr("Open surface"),
                  scene.surface.file.empty()
                      ? folder()
                      : QString::fromStdString((scene.folder / scene.surface.file).string()),
                  tr("Measured surfaces (%1);;All files (*)").arg(patterns.join(' ')),
                  QFileDialog::HideNameFilterDetails);
  if (!file.isEmpty()) showSurface(scene, file);
}

void ImportCommands::askMaterial() {
  const QString file = askOpenFile(
      &parts_.window, tr("Open material"), folder(),
      tr("Materials and measured moduli (*.json *.csv *.txt *.dat *.inp);;All files (*)"),
      QFileDialog::HideNameFilterDetails);
  if (!file.isEmpty()) openMaterial(file);
}

void ImportCommands::closePages() {
  for (QDialog* page : parts_.window.findChildren<QDialog*>(Qt::FindDirectChildrenOnly))
    if (qobject_cast<ImportPage*>(page) && page->isVisible()) page->reject();
}

SurfaceImport& ImportCommands::openSurface(const QString& file) {
  return showSurface(parts_.document.scene(), file);
}

SurfaceImport& ImportCommands::showSurface(const Scene& scene, const QString& file) {
  closePages();
  auto* page = new SurfaceImport(scene, QFileInfo(file).absoluteFilePath(), &parts_.window);
  connect(page, &SurfaceImport::sceneChosen, this,
          [this, file](const Scene& chosen) { takeSurface(chosen, file); });
  page->open();
  return *page;
}

namespace {

/// Returns the title of a scene that has none of its own: the name of its surface's file.
std::string titleFromFile(const QString& file) {
  return printable(QFileInfo(file).completeBaseName().toStdString());
}

}  // namespace

/// A title and a description that belong to a shipped scene, or a title that was taken from the
/// previous surface, do not fit another surface.
void ImportCommands::takeSurface(Scene scene, const QString& file) {
  const Surface& previous = parts_.document.scene().surface;
  const bool isOfPrevious = hasSurfaceFile(previous) &&
                            scene.title == titleFromFile(QString::fromStdString(previous.file));
  const bool isShipped = std::ranges::any_of(libraryScenes(), [&](const LibraryScene& shipped) {
    return shipped.scene.title == scene.title;
  });
  if (scene.title.empty() || isShipped || isOfPrevious) {
    scene.title = titleFromFile(file);
    scene.description.clear();
    scene.chapter.clear();
  }
  parts_.document.edit(scene, QT_TRANSLATE_NOOP("asperity::SceneDocument", "Open surface"));
  emit imported();
}

void ImportCommands::openMaterial(const QString& file) {
  if (kindOfFile(file.toStdString()) == FileKind::Material)
    takeMaterial(file);
  else
    openModuli(file);
}

MaterialImport& ImportCommands::openModuli(const QString& file) {
  closePages();
  auto* page = new MaterialImport(QFileInfo(file).absoluteFilePath(), &parts_.window);
  connect(page, &MaterialImport::materialWritten, this, &ImportCommands::takeMaterial);
  page->open();
  return *page;
}

void ImportCommands::takeMaterial(const QString& file) {
  Scene scene = parts_.document.scene();
  const bool isRead = parts_.messages.succeeds(MessageBar::Failure::Files, [&] {
    useMaterial(scene, nameInScene(scene, QFileInfo(file).absoluteFilePath().toStdString()));
  });
  if (!isRead) return;
  parts_.document.edit(scene, QT_TRANSLATE_NOOP("asperity::SceneDocument", "Open material"));
  emit imported();
}

bool ImportCommands::askFriction() {
  const QString file =
      askOpenFile(&parts_.window, tr("Add measured friction"), folder(),
                  tr("Tables of velocity and friction (*.csv *.txt *.dat *.tsv);;All files (*)"),
                  QFileDialog::HideNameFilterDetails);
  return !file.isEmpty() && takeFriction(file);
}

/// Adds measured friction beside the curve; a table that was added before is read again. Returns
/// whether it could be read.
bool ImportCommands::takeFriction(const QString& file) {
  Scene scene = parts_.document.scene();
  const std::string path = QFileInfo(file).absoluteFilePath().toStdString();
  std::vector<Message> remarks;  // on what is not used
  const bool isRead = parts_.messages.succeeds(MessageBar::Failure::Files, [&] {
    const FrictionData data = readFrictionData(path);
    // The first note states how the columns were understood.
    for (std::size_t i = 1; i < data.notes.size(); ++i)
      remarks.push_back(message("{}: {}", data.name, data.notes[i]));
  });
  if (!isRead) return false;
  const std::string name = nameInScene(scene, path);
  if (std::ranges::find(scene.comparison.data, name, &DataFile::file) ==
      scene.comparison.data.end())
    scene.comparison.data.push_back({name, {}});
  parts_.document.edit(scene,
                       QT_TRANSLATE_NOOP("asperity::SceneDocument", "Add measured friction"));
  if (!remarks.empty())
    parts_.messages.showMessage([remarks] {
      QStringList lines;
      for (const Message& remark : remarks) lines += translatedText(remark);
      return lines.join('\n');
    });
  emit imported();
  return true;
}

void ImportCommands::openDropped(const QString& file) {
  work_.request([file](const BackgroundWork::Run&) { return kindOfFile(file.toStdString()); },
                [this, file](FileKind kind) {
                  switch (kind) {
                    case FileKind::Scene:
                      return parts_.documents.openFile(file);
                    case FileKind::Material:
                      return takeMaterial(file);
                    case FileKind::Moduli:
                      openModuli(file);
                      return;
                    case FileKind::Friction:
                      takeFriction(file);
                      return;
                    case FileKind::Surface:
                      openSurface(file);
                      return;
                  }
                },
                parts_.messages.failureReporter(MessageBar::Failure::Files));
}

}  // namespace asperity
