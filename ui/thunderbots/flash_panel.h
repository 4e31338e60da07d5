#pragma once

#include "core/thunderbots/commands.h"
#include "ui/shell/panel.h"
#include "ui/thunderbots/flash_wizard_state.h"

class QLabel;
class QPushButton;
class QStackedWidget;

namespace kickstand::ui {

class FlashFilesPage;
class FlashProgressPage;
class FlashResultPage;
class FlashReviewPage;
class FlashRobotsPage;
class FlashStepStrip;
class RobotChoice;

/// Firmware into robots, page by page: which robots, which files, what will happen, how it goes, how it
/// ended. No page can be passed with something wrong on it. A panel and not a dialog: STOP and everything
/// else stay in reach. Closing it hides it and stops nothing.
class FlashPanel final : public Panel {
    Q_OBJECT
  public:
    FlashPanel(Bench& bench, RobotChoice& choice, QWidget* parent = nullptr);

    /// Reads firmware files as if a person had chosen them.
    void addFiles(const QStringList& paths);

  protected:
    void showEvent(QShowEvent* event) override;

  private:
    void build();
    QWidget* makeFooter();
    void addShortcuts();
    void connectPages();
    void connectBench();

    void refresh();
    void showPage();
    void showFooter();
    void showNote();
    void followLink();
    void followChoice();
    void sessionGone();
    void go(FlashStep step);
    void goBack();
    void goOn();

    void takeFile(const FlashFile& file);
    void removeFile(std::size_t file);
    void remedy(int robot);
    void disarmDischarged(const thunderbots::Snapshot& snapshot);
    void forgetReviews();
    void readAgain();
    void readRobots();
    void readRobot(int robot);
    void start();
    void cancel(thunderbots::RobotMask robots);
    void resume(thunderbots::RobotMask robots);
    void uploadAgain(thunderbots::RobotMask robots);
    void startOver();
    void saveLogs(thunderbots::RobotMask robots);
    QByteArray logsOf(thunderbots::RobotMask robots) const;
    /// Asks for something whose refusal stands in the footer.
    void ask(const thunderbots::Command& command);
    const thunderbots::Snapshot* snapshot() const;

    RobotChoice& choice_;
    FlashWizardState state_;
    FlashReader reader_;
    FlashStepStrip* strip_;
    QStackedWidget* pages_;
    FlashRobotsPage* robotsPage_;
    FlashFilesPage* filesPage_;
    FlashReviewPage* reviewPage_;
    FlashProgressPage* progressPage_;
    FlashResultPage* resultPage_;
    QPushButton* back_ = nullptr;
    QLabel* reason_ = nullptr;
    QPushButton* next_ = nullptr;
    QString refusal_;
    QString filesNotice_;
    bool linked_ = false;                        ///< Whether the link ran when last looked at.
    quint64 reviewRound_ = 0;                    ///< Answers to earlier questions mean nothing any more.
    thunderbots::RobotMask discharging_ = 0;     ///< Armed here for a discharge that has been seen to run.
    thunderbots::RobotMask dischargeAsked_ = 0;  ///< The same, not yet seen to run.
};

}  // namespace kickstand::ui
