#pragma once

#include <array>

#include "ui/thunderbots/flash_page.h"
#include "ui/thunderbots/flash_wizard_state.h"

class QComboBox;

namespace kickstand::ui {

class StateLabel;

/// The wizard's second page: which files, what each of them is, whom it is for, and what speaks against it.
class FlashFilesPage final : public FlashPageView {
    Q_OBJECT
  public:
    explicit FlashFilesPage(QWidget* parent = nullptr);

    /// `notice`: what a person is to be told beside that, such as a file too many; or empty.
    void showState(const FlashWizardState& state, const QString& notice);

  signals:
    void pathsAsked(const QStringList& paths);
    void removeAsked(std::size_t file);
    void targetAsked(std::size_t file, thunderbots::image::FlashTarget target);

  protected:
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

  private:
    struct Card {
        QWidget* all = nullptr;
        QLabel* name = nullptr;
        QComboBox* target = nullptr;
        QLabel* why = nullptr;
        QLabel* facts = nullptr;
        StateLabel* verdict = nullptr;
        QLabel* problem = nullptr;
    };

    Card makeCard(std::size_t file);
    QWidget* makeCardHead(Card& card, std::size_t file);
    void showCard(const Card& card, const FlashFile& file);
    void ask();

    std::array<Card, FlashWizardState::kMostFiles> cards_;
    QLabel* empty_;
    QLabel* order_;
    QPushButton* addFpga_;
    QLabel* notice_;
    QPushButton* choose_;
};

}  // namespace kickstand::ui
