#include "ui/window/export/command_run.h"

#include <QCoreApplication>
#include <QProcessEnvironment>
#include <QTimer>

namespace asperity {

namespace {

constexpr int kTimeToEnd = 3000;  // ms, until a call that was asked to end is killed

}  // namespace

CommandRun::CommandRun(const QString& program, QObject* parent)
    : QObject(parent),
      program_(program.isEmpty() ? QCoreApplication::applicationFilePath() : program) {}

CommandRun::~CommandRun() {
  cancel();
}

void CommandRun::run(const QStringList& words, const QString& folder) {
  cancel();
  errors_.clear();
  height_ = {};
  auto* process = new QProcess(this);
  process_ = process;
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  environment.insert("ASPERITY_PROGRESS", "1");
  process->setProcessEnvironment(environment);
  process->setWorkingDirectory(folder);
  process->setProgram(program_);
  process->setArguments(words.mid(1));
  process->setStandardInputFile(QProcess::nullDevice());
  connect(process, &QProcess::readyReadStandardError, this, &CommandRun::readErrors);
  connect(process, &QProcess::finished, this, [this](int status, QProcess::ExitStatus end) {
    finish(status, end == QProcess::CrashExit);
  });
  connect(process, &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
    if (error != QProcess::FailedToStart || !process_) return;
    process_->deleteLater();
    process_ = nullptr;
    emit failed(tr("The program %1 cannot be started").arg(program_), {});
  });
  process->start();
}

/// Asks the call to end, as Ctrl+C does, and does not wait for it. While the program quits, it
/// waits a few seconds for such calls, so that they can remove their temporary files.
void CommandRun::cancel() {
  QProcess* process = process_;
  process_ = nullptr;
  if (!process) return;
  process->disconnect(this);
  process->setParent(QCoreApplication::instance());
  connect(process, &QProcess::finished, process, &QObject::deleteLater);
  if (process->state() == QProcess::NotRunning) return process->deleteLater();
  process->terminate();
  connect(QCoreApplication::instance(), &QCoreApplication::aboutToQuit, process,
          [process] { process->waitForFinished(kTimeToEnd); });
  QTimer::singleShot(kTimeToEnd, process, &QProcess::kill);
}

/// Reads complete lines: those of progress and of a needed height contain numbers, the others are
/// error messages.
void CommandRun::readErrors() {
  if (!process_) return;
  errors_ += process_->readAllStandardError();
  const auto hasNumbers = [this] {
    return errors_.startsWith("progress ") || errors_.startsWith("height ");
  };
  for (qsizetype end = 0; (end = errors_.indexOf('\n')) >= 0 && hasNumbers();) {
    const QString line = QString::fromUtf8(errors_.left(end));
    errors_.remove(0, end + 1);
    const double done = line.section(' ', 1, 1).toDouble(),
                 total = line.section(' ', 2, 2).toDouble();
    if (line.startsWith("height "))
      height_ = {static_cast<int>(done), static_cast<int>(total)};
    else if (total > 0)
      emit progressed(done / total, line.section(' ', 3));
  }
}

void CommandRun::finish(int status, bool hasCrashed) {
  if (!process_) return;
  readErrors();
  QProcess* process = process_;
  process_ = nullptr;
  process->deleteLater();
  if (!hasCrashed && status == 0) return emit done(process->readAllStandardOutput());
  QString reason;
  for (const QByteArray& line : errors_.split('\n'))
    if (line.startsWith("asperity: ")) reason = QString::fromUtf8(line.mid(10));
  if (reason.isEmpty()) reason = tr("The program ended without a reason");
  emit failed(reason, height_);
}

}  // namespace asperity
