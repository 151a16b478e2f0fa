// The commands that open what a person measured: a surface, a material. They show the page of the
// file and make its result the next step of the document; and they take files that are dropped on
// the window, of any kind. Owned by the main window; GUI thread. Failure: on the page, or in the
// message bar.
#pragma once

#include <QObject>
#include <QString>
#include <filesystem>

#include "core/scene/scene.h"
#include "ui/window/tasks/background_work.h"

class QWidget;

namespace asperity {

class Commands;
class DocumentCommands;
class MaterialImport;
class MessageBar;
class ParameterPanel;
class SceneDocument;
class SurfaceImport;

enum class FileKind {
  Scene,     // a scene, or what the program made from one; also what cannot be read at all
  Material,  // material.json
  Moduli,    // measured moduli, or a ready Prony series
  Friction,  // measured coefficients of friction
  Surface,   // anything else
};

/// Returns the kind of a file from its content. It only reads the file; any thread.
FileKind kindOfFile(const std::filesystem::path& file);

class ImportCommands : public QObject {
  Q_OBJECT

 public:
  struct Parts {
    QWidget& window;
    SceneDocument& document;
    DocumentCommands& documents;
    ParameterPanel& panel;
    MessageBar& messages;
  };
  explicit ImportCommands(const Parts& parts);

  void addTo(Commands& commands);

  /// Shows the page of a measured surface; replaces the page that is open.
  SurfaceImport& openSurface(const QString& file);
  /// Makes a material.json the material of the scene, or shows the page of measured moduli.
  void openMaterial(const QString& file);
  MaterialImport& openModuli(const QString& file);
  /// Puts measured friction beside the curve, from a file that the user chooses; returns whether
  /// that was done.
  bool askFriction();
  /// Detects the kind of the file in the background and opens it accordingly.
  void openDropped(const QString& file);

 signals:
  /// Emitted when a file has become a part of the scene, which is then shown.
  void imported();

 private:
  SurfaceImport& showSurface(const Scene& scene, const QString& file);
  void askSurface(const Scene& scene);
  void askMaterial();
  void takeSurface(Scene scene, const QString& file);
  void takeMaterial(const QString& file);
  bool takeFriction(const QString& file);
  void closePages();
  QString folder() const;

  Parts parts_;
  BackgroundWork work_;  // last: its thread ends before other members are destroyed
};

}  // namespace asperity
