// Materials in the window: the page of measured moduli, the box of the panel, the tab.
#include "ui/window/import/material_import.h"

#include <gtest/gtest.h>

#include <QClipboard>
#include <QComboBox>
#include <QFile>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPointer>
#include <QPushButton>
#include <QSpinBox>
#include <QTabBar>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QToolButton>

#include "core/material/material_options.h"
#include "core/scene/scene_file.h"
#include "tests/ui/window/main_window_fixture.h"
#include "tests/ui/window/qt_application.h"
#include "ui/window/figures/diagram_view.h"
#include "ui/window/import/import_commands.h"
#include "ui/window/import/surface_import.h"
#include "ui/window/main/scene_tabs.h"

namespace asperity {
namespace {

const QString kMeasurements = ASPERITY_RESOURCES_DIR "/materials/measurements/epdm_70.csv";

class MaterialImportTest : public MainWindowTest {
 protected:
  MaterialImport& openPage(const QString& file = kMeasurements) {
    page_ = &window_.imports().openModuli(file);
    page_->setFileChooser(
        [this](QWidget*, const QString&) { return folder_.filePath("own.json"); });
    return *page_;
  }
  bool waitForPage() {
    return waitFor([&] { return page_ && !page_->isReading(); });
  }
  template <class Control>
  Control& inPage(const QString& name) {
    return *page_->findChild<Control*>(name);
  }
  void enter(const QString& name, const QString& text) {
    auto& entry = inPage<QLineEdit>(name);
    entry.setFocus();
    entry.selectAll();
    QTest::keyClicks(&entry, text);
    QTest::keyClick(&entry, Qt::Key_Return);
  }
  const Scene& scene() { return window_.document().scene(); }
  QString writeTable(const QString& name, const QByteArray& text) {
    QFile file(folder_.filePath(name));
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(text);
    return file.fileName();
  }

  QTemporaryDir folder_;
  QPointer<MaterialImport> page_;
};

TEST_F(MaterialImportTest, WritesTheMaterialAndMakesItThatOfTheScene) {
  const Scene before = scene();
  openPage();
  ASSERT_TRUE(waitForPage());
  ASSERT_TRUE(page_->isReady()) << page_->errorText().toStdString();
  EXPECT_EQ(inPage<QTabBar>("dmaSheets").count(), 4);
  EXPECT_FALSE(inPage<QLabel>("dmaSummary").text().isEmpty());
  auto& sheet = inPage<DiagramView>("dmaSheet");
  EXPECT_TRUE(waitFor([&] { return sheet.isPainted(); }));
  const std::vector<Arm> arms = page_->material()->series.arms;
  QTest::mouseClick(&inPage<QPushButton>("importAccept"), Qt::LeftButton);
  ASSERT_TRUE(waitFor([&] { return page_.isNull(); }));
  EXPECT_TRUE(QFile::exists(folder_.filePath("own.json")));
  EXPECT_EQ(scene().elastomer.rheology, Rheology::Prony);
  EXPECT_EQ(scene().elastomer.arms, arms);
  EXPECT_TRUE(QString::fromStdString(scene().elastomer.material).endsWith("own.json"));
  EXPECT_EQ(window_.document().history().count(), 1);
  // The file alone gives the same elastomer to a command.
  const Scene told =
      readScene("{}", "told", {}, {"elastomer.material=" + scene().elastomer.material});
  EXPECT_EQ(told.elastomer.arms, arms);
  window_.document().history().undo();
  EXPECT_EQ(scene(), before);
}

TEST_F(MaterialImportTest, ChoicesMakeItAnew) {
  openPage();
  ASSERT_TRUE(waitForPage());
  inPage<QSpinBox>("dmaTerms").setValue(7);
  ASSERT_TRUE(waitForPage());
  EXPECT_EQ(page_->material()->series.terms, 7);
  enter("dmaReference", "15 °C");
  ASSERT_TRUE(waitForPage());
  ASSERT_TRUE(page_->isReady()) << page_->errorText().toStdString();
  EXPECT_NEAR(page_->material()->referenceTemperature, 288.15, 1e-9);
  enter("dmaPoisson", "0,45");
  ASSERT_TRUE(waitForPage());
  ASSERT_TRUE(page_->isReady()) << page_->errorText().toStdString();
  // As the command would note them, which knows no decimal comma.
  EXPECT_EQ(page_->material()->options, (WrittenOptions{{"--poisson-ratio", "0.45"},
                                                        {"--reference-temperature", "15 °C"},
                                                        {"--terms", "7"}}));
  enter("dmaReference", "warm");
  ASSERT_TRUE(waitForPage());
  EXPECT_FALSE(page_->isReady());
  EXPECT_TRUE(page_->errorText().contains("warm"));
  EXPECT_FALSE(inPage<QPushButton>("importAccept").isEnabled());
  enter("dmaReference", "20.5");  // kelvins or degrees?
  ASSERT_TRUE(waitForPage());
  EXPECT_TRUE(page_->errorText().contains("has no unit")) << page_->errorText().toStdString();
  enter("dmaReference", "300 °C");  // outside of what was measured
  ASSERT_TRUE(waitForPage());
  EXPECT_FALSE(page_->isReady());
  EXPECT_FALSE(page_->errorText().contains('\n'));
}

/// The page still has the material, and another folder takes it. The measurements are never
/// replaced.
TEST_F(MaterialImportTest, WhatCannotBeWrittenThereIsWrittenElsewhere) {
  const QString measurements = folder_.filePath("own.csv");
  ASSERT_TRUE(QFile::copy(kMeasurements, measurements));
  openPage(measurements);
  ASSERT_TRUE(waitForPage());
  auto& accept = inPage<QPushButton>("importAccept");
  for (const QString& file : {QStringLiteral("/nowhere/own.json"), measurements}) {
    page_->setFileChooser([&](QWidget*, const QString&) { return file; });
    accept.click();
    ASSERT_TRUE(page_);
    EXPECT_TRUE(page_->errorText().contains(file)) << page_->errorText().toStdString();
    EXPECT_TRUE(accept.isEnabled());
    EXPECT_TRUE(inPage<DiagramView>("dmaSheet").isVisibleTo(page_));
  }
  QFile kept(measurements), original(kMeasurements);
  ASSERT_TRUE(kept.open(QIODevice::ReadOnly) && original.open(QIODevice::ReadOnly));
  EXPECT_EQ(kept.readAll(), original.readAll());
  page_->setFileChooser([this](QWidget*, const QString&) { return folder_.filePath("own.json"); });
  accept.click();
  EXPECT_TRUE(waitFor([&] { return page_.isNull(); }));
  EXPECT_TRUE(QFile::exists(folder_.filePath("own.json")));
}

TEST_F(MaterialImportTest, TheTabKeyComesToTheButtonsLast) {
  const auto placeOf = [](const QWidget& page, const QWidget& control) {
    int place = 0;
    for (const QWidget* one = &page; one != &control; one = one->nextInFocusChain()) ++place;
    return place;
  };
  openPage();
  EXPECT_LT(placeOf(*page_, inPage<QLineEdit>("dmaSource")),
            placeOf(*page_, inPage<QPushButton>("importCancel")));
  SurfaceImport& surface = window_.imports().openSurface(kMeasurements);
  EXPECT_LT(placeOf(surface, *surface.panel().findChildren<ValueEntry*>().constLast()),
            placeOf(surface, *surface.findChild<QPushButton*>("importCancel")));
}

/// A user mends the table in another program while the page says what is wrong with it.
TEST_F(MaterialImportTest, AMendedFileIsReadAgain) {
  const QString file = writeTable("own.csv", "frequency [Hz],G' [MPa],G'' [MPa]\n1,2,0.2\n");
  openPage(file);
  ASSERT_TRUE(waitForPage());
  EXPECT_FALSE(page_->isReady());
  ASSERT_TRUE(QFile::remove(file) && QFile::copy(kMeasurements, file));
  enter("dmaReference", "15 °C");
  ASSERT_TRUE(waitForPage());
  EXPECT_TRUE(page_->isReady()) << page_->errorText().toStdString();
}

TEST_F(MaterialImportTest, SaysWhatIsWrongWithAFile) {
  openPage(writeTable("one.csv", "frequency [Hz],G' [MPa],G'' [MPa]\n1,2,0.2\n"));
  ASSERT_TRUE(waitForPage());
  EXPECT_FALSE(page_->isReady());
  EXPECT_FALSE(page_->errorText().isEmpty());
  EXPECT_FALSE(page_->errorText().contains('\n'));
}

/// Core speaks of options of the command; the page names its own controls.
TEST_F(MaterialImportTest, AComplaintNamesTheControlThatHelps) {
  openPage(writeTable("parts.csv", "tau (s),g\n0.001,0.3\n0.1,0.2\n"));
  ASSERT_TRUE(waitForPage());
  EXPECT_FALSE(page_->isReady());
  EXPECT_TRUE(page_->errorText().contains("instantaneous modulus G₀”"))
      << page_->errorText().toStdString();
  EXPECT_FALSE(page_->errorText().contains("--")) << page_->errorText().toStdString();
  enter("dmaInstantaneous", "10 MPa");
  ASSERT_TRUE(waitForPage());
  EXPECT_TRUE(page_->errorText().contains("test temperature”")) << page_->errorText().toStdString();
  enter("dmaTemperature", "20 °C");
  ASSERT_TRUE(waitForPage());
  ASSERT_TRUE(page_->isReady()) << page_->errorText().toStdString();
  EXPECT_NEAR(page_->material()->series.equilibriumModulus, 0.5 * 10e6, 1);
}

/// A table whose columns have names of their own: the page asks for them, and can be told.
TEST_F(MaterialImportTest, ColumnsCanBeSaid) {
  QFile file(folder_.filePath("mine.csv"));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("run,drive,cold,one,two\n");
  for (int i = 0; i < 10; ++i)
    file.write(QByteArray("1,") + QByteArray::number(0.1 * (1 << i)) + ",20," +
               QByteArray::number(1 + 0.2 * i) + "," + QByteArray::number(0.2 + 0.01 * i) + "\n");
  file.close();
  openPage(file.fileName());
  ASSERT_TRUE(waitForPage());
  EXPECT_TRUE(page_->errorText().contains("“frequency column”"))
      << page_->errorText().toStdString();
  EXPECT_TRUE(page_->errorText().startsWith("mine.csv")) << page_->errorText().toStdString();
  // The names stand where they are asked for.
  auto& beginning = inPage<QPlainTextEdit>("importBeginning");
  EXPECT_TRUE(beginning.isVisibleTo(page_));
  EXPECT_TRUE(beginning.toPlainText().startsWith("run,drive,cold,one,two\n1,0.1,20"));
  EXPECT_FALSE(inPage<DiagramView>("dmaSheet").isVisibleTo(page_));
  for (const auto& [entry, column] : {std::pair{"dmaFrequencyColumn", "drive"},
                                      {"dmaTemperatureColumn", "3"},
                                      {"dmaStorageColumn", "one"},
                                      {"dmaLossColumn", "two"}}) {
    enter(entry, column);
    ASSERT_TRUE(waitForPage());
  }
  for (const auto& [box, word] : {std::pair{"dmaModulus", "shear"},
                                  {"dmaModulusUnit", "MPa"},
                                  {"dmaFrequencyUnit", "Hz"},
                                  {"dmaTemperatureUnit", "C"}}) {
    auto& choice = inPage<QComboBox>(box);
    choice.setCurrentIndex(choice.findData(word));
    emit choice.activated(choice.currentIndex());
    ASSERT_TRUE(waitForPage());
  }
  EXPECT_TRUE(page_->isReady()) << page_->errorText().toStdString();
}

TEST_F(MaterialImportTest, DroppedFilesAreOpenedAsWhatTheyAre) {
  EXPECT_EQ(kindOfFile(kMeasurements.toStdString()), FileKind::Moduli);
  EXPECT_EQ(kindOfFile(ASPERITY_RESOURCES_DIR "/materials/epdm_70.json"), FileKind::Material);
  EXPECT_EQ(kindOfFile(ASPERITY_RESOURCES_DIR "/scenes/figure_1.json"), FileKind::Scene);
  EXPECT_EQ(kindOfFile("gone.csv"), FileKind::Scene);
  QFile file(folder_.filePath("line.txt"));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("0 1\n1 2\n2 1\n3 0\n");
  file.close();
  EXPECT_EQ(kindOfFile(file.fileName().toStdString()), FileKind::Surface);

  drop(ASPERITY_RESOURCES_DIR "/materials/epdm_70.json");
  ASSERT_TRUE(waitFor([&] { return scene().elastomer.rheology == Rheology::Prony; }));
  EXPECT_GT(scene().elastomer.arms.size(), 4U);
  drop(kMeasurements);
  ASSERT_TRUE(waitFor([&] { return window_.findChild<MaterialImport*>() != nullptr; }));
}

TEST_F(MaterialImportTest, TheBoxOfThePanelNamesMaterials) {
  auto& rheology = control<QComboBox>("choice:elastomer.rheology");
  rheology.setCurrentIndex(rheology.findData("prony"));
  emit rheology.activated(rheology.currentIndex());
  auto& box = control<QComboBox>("material:elastomer.material");
  ASSERT_TRUE(box.isVisibleTo(&window_.panel()));
  EXPECT_EQ(box.currentIndex(), 0);
  const int index = box.findData("epdm_70");
  ASSERT_GE(index, 0);
  const double temperature = scene().elastomer.temperature;
  box.setCurrentIndex(index);
  emit box.activated(index);
  EXPECT_EQ(scene().elastomer.material, "epdm_70");
  EXPECT_GT(scene().elastomer.arms.size(), 4U);
  EXPECT_EQ(scene().elastomer.temperature, temperature);
  EXPECT_EQ(box.currentData().toString(), "epdm_70");
  ASSERT_TRUE(waitForFrame());
  // A value of one's own beside the material keeps its name.
  const std::size_t arms = scene().elastomer.arms.size();
  QTest::mouseClick(&control<QToolButton>("reset:elastomer.material"), Qt::LeftButton);
  EXPECT_EQ(scene().elastomer.material, "");
  EXPECT_EQ(scene().elastomer.arms.size(), arms);
}

/// The diagram of the tab is made again for another velocity, and can be saved.
TEST_F(MaterialImportTest, TheTabFollowsTheVelocity) {
  Scene rubber = scene();
  rubber.elastomer = readScene("{}", "", {}, {"elastomer.material=epdm_70"}).elastomer;
  window_.document().edit(rubber);
  auto& tabs = control<QTabWidget>("tabs");
  auto& view = control<DiagramView>("materialView");
  tabs.setCurrentWidget(&view);
  ASSERT_TRUE(waitFor([&] { return view.isPainted(); }));
  const QImage slow = view.image();
  Scene fast = rubber;
  fast.sliding.velocity *= 1000;
  window_.document().edit(fast);
  EXPECT_TRUE(waitFor([&] { return view.isPainted() && view.image() != slow; }));

  QSignalSpy saved(&view.files(), &DiagramFiles::saved);
  for (const char* name : {"material.png", "material.svg", "material.csv"}) {
    view.files().save(folder_.filePath(name));
    ASSERT_TRUE(waitFor([&] { return !saved.isEmpty(); })) << name;
    saved.clear();
    EXPECT_TRUE(QFile::exists(folder_.filePath(name))) << name;
  }
  QFile table(folder_.filePath("material.csv"));
  ASSERT_TRUE(table.open(QIODevice::ReadOnly));
  EXPECT_TRUE(table.readLine().startsWith("# asperity: "));
  EXPECT_TRUE(table.readLine().startsWith("frequency,storage_modulus,loss_modulus"));
  view.files().save("/nowhere/material.png");
  ASSERT_TRUE(waitFor([&] { return window_.messages().isVisible(); }));
}

}  // namespace
}  // namespace asperity
