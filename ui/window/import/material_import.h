// The page on which measured moduli become a material: isotherms, the master curve with its fit and
// the shifts are drawn again after each change of reference temperature, terms or units. A given
// Prony series is shown in the same way. The material is written to a file that the user chooses
// and becomes that of the scene. Object names: those of ImportPage; "dmaReference", "dmaTerms",
// "dmaShift", "dmaVertical", "dmaModulus", "dmaPoisson", "dmaFrequencyUnit", "dmaTemperatureUnit",
// "dmaModulusUnit", "dmaTemperature", "dmaInstantaneous", "dmaEquilibrium", "dmaLiquid", "dmaName",
// "dmaSource", "dmaSheets", "dmaSheet", "dmaWarnings", "dmaSummary". GUI thread; deletes itself.
// Failure: one line on the page.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/material/material_model.h"
#include "ui/panels/controls.h"
#include "ui/window/import/import_page.h"

class QFormLayout;
class QLabel;
class QLineEdit;
class QTabBar;

namespace asperity {

class DiagramView;

class MaterialImport : public ImportPage {
  Q_OBJECT

 public:
  MaterialImport(const QString& file, QWidget* parent = nullptr);

  /// Returns what is shown; null before, or where the choices are wrong.
  const Material* material() const { return material_.get(); }

  /// Replaces the usual file dialog.
  void setFileChooser(FileChooser chooser) { chooser_ = std::move(chooser); }

  void accept() override;

 signals:
  /// Emitted with the file that the material was written into.
  void materialWritten(const QString& file);

 protected:
  void begin() override;

 private:
  struct Preview;
  void buildViews();
  void buildChoices();
  void addMeasurement(QFormLayout& form);
  void addColumns(QFormLayout& form);
  void addMasterCurve(QFormLayout& form);
  void addSeries(QFormLayout& form);
  /// A control of an option of `asperity material`.
  struct Control {
    const char* option;
    QString label;
    std::function<QString()> value;  // as the command takes it; empty: the option is not given
  };
  /// Returns a text that was typed, which is not empty, as the command takes it. Throws InputError.
  using Reader = QString (*)(const QString& text, const char* option);
  QLineEdit* addEntry(QFormLayout& form, const char* option, const char* name, const QString& label,
                      const QString& tip, Reader read = nullptr);
  void addChoice(QFormLayout& form, const char* option, const char* name, const QString& label,
                 const QString& tip, const QString& automatic, const QStringList& words);
  void addCheck(QFormLayout& form, const char* option, const char* name, const QString& label,
                const QString& tip = {});
  MaterialChoices choices() const;
  QString withControlNames(const std::string& option, QString text) const;
  void take(const Preview& preview);
  void refuse(const std::string& option, const Message& reason);
  void showSheet();

  FileChooser chooser_;
  std::shared_ptr<const std::string> bytes_;  // of the file, once a material was made of them
  std::shared_ptr<const Material> material_;
  DiagramView* sheet_;
  QTabBar* sheets_;
  QLabel *warnings_, *summary_;
  QLineEdit* reference_ = nullptr;
  std::vector<Control> controls_;
};

}  // namespace asperity
