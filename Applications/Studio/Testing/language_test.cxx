// The window in a language that nobody speaks: whatever is seen is in it, and nothing is cut off.
#include "language.h"
#include "status_labels.h"

#include "document.h"
#include "resources.h"
#include "scene.h"
#include "tool.h"

#include <QAbstractButton>
#include <QComboBox>
#include <QDockWidget>
#include <QFileInfo>
#include <QLabel>
#include <QListWidget>
#include <QMenu>
#include <QMenuBar>
#include <QStyle>
#include <QStyleOptionComboBox>
#include <QTemporaryDir>
#include <QToolButton>
#include <QTranslator>

#include <iostream>
#include <set>
#include <string>

using namespace oversketch_studio;

namespace
{

bool isSeen(const QWidget* widget)
{
  return widget->isVisible() && !widget->visibleRegion().isEmpty();
}

// What a widget shows, and how much room it has and needs [px]; empty where it shows no text.
struct Shown
{
  QString text;
  int has = 0, needs = 0;
};

Shown shownBy(const QWidget* widget)
{
  const QFontMetrics font = widget->fontMetrics();
  if (const auto* advice = qobject_cast<const AdviceLabel*>(widget))
  {
    // In the letters of the window, or nearly; what is seen of it.
    QFont font = advice->font();
    font.setPointSizeF(0.85 * font.pointSizeF());
    const QRect room(0, 0, advice->width() - advice->indent(), QWIDGETSIZE_MAX);
    return { advice->text(),
      advice->height(),
      QFontMetrics(font).boundingRect(room, Qt::TextWordWrap, advice->shown()).height() };
  }
  if (const auto* label = qobject_cast<const QLabel*>(widget))
  {
    if (label->wordWrap())
    {
      return { label->text(), label->height(), label->heightForWidth(label->width()) };
    }
    return { label->text(), label->width(), label->text().isEmpty() ? 0 : label->minimumSizeHint().width() };
  }
  if (const auto* choice = qobject_cast<const QComboBox*>(widget))
  {
    QStyleOptionComboBox option;
    option.initFrom(choice);
    const QRect room =
      choice->style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, choice);
    return { choice->currentText(), room.width(), font.horizontalAdvance(choice->currentText()) };
  }
  if (const auto* button = qobject_cast<const QToolButton*>(widget))
  {
    const bool hasText = button->toolButtonStyle() != Qt::ToolButtonIconOnly || button->icon().isNull();
    return {
      hasText ? button->text() : QString(), button->width(), hasText ? button->minimumSizeHint().width() : 0
    };
  }
  if (const auto* button = qobject_cast<const QAbstractButton*>(widget))
  {
    return {
      button->text(), button->width(), button->text().isEmpty() ? 0 : button->minimumSizeHint().width()
    };
  }
  return {};
}

// What is cut off in a window, once each.
std::set<std::string> cutOff(const QWidget& window, int& looked)
{
  std::set<std::string> found;
  for (const QWidget* widget : window.findChildren<QWidget*>())
  {
    if (!isSeen(widget))
    {
      continue;
    }
    const Shown shown = shownBy(widget);
    if (shown.text.isEmpty())
    {
      continue;
    }
    ++looked;
    // Seen, and as wide as it needs.
    const bool isWhole =
      widget->visibleRegion().boundingRect().width() >= std::min(widget->width(), shown.needs) - 2;
    if (shown.has < shown.needs - 1 || !isWhole)
    {
      found.insert(widget->objectName().toStdString() + ' ' + widget->metaObject()->className() + " \"" +
                   shown.text.toStdString() + "\": " + std::to_string(shown.has) + " of " +
                   std::to_string(shown.needs));
    }
  }
  return found;
}

// A person who looks at everything: each tool with its options, a step that is selected, one that failed.
void tour(Scene& scene, const std::function<void(const std::string& where)>& look)
{
  const auto see = [&](const std::string& where)
  {
    QApplication::processEvents();
    look(where);
  };
  see("first");
  for (Tool* tool : scene.view->findChildren<Tool*>())
  {
    QTest::keyClick(scene.view, static_cast<Qt::Key>(tool->key()[0]));
    see(tool->objectName().toStdString());
  }
  QTest::keyClick(scene.view, Qt::Key_D);
  scene.draw();
  scene.release();
  scene.wait();
  see("a stroke");
  scene.window.findChild<QListWidget*>("history")->setCurrentRow(0);
  see("a step");
  // One that is refused, in a filter's words.
  QTest::mousePress(scene.view, Qt::LeftButton, Qt::NoModifier, { 5, 5 });
  for (int x = 5; x < 12; ++x)
  {
    moveMouse(scene.view, { x, 5 });
  }
  QTest::mouseRelease(scene.view, Qt::LeftButton, Qt::NoModifier, { 12, 5 });
  scene.wait();
  see("a refused stroke");
  for (QMenu* menu : scene.window.findChildren<QMenu*>())
  {
    emit menu->aboutToShow();
  }
  see("menus");
}

} // namespace

TEST(Language, ATranslationIsOneFileMoreAndNothingEscapesIt)
{
  const QTemporaryDir folder;
  {
    Listener listener;
    QCoreApplication::installTranslator(&listener);
    {
      Scene scene;
      scene.window.resize(1200, 800);
      tour(scene, [](const std::string&) {});
    }
    QCoreApplication::removeTranslator(&listener);
    ASSERT_GT(listener.heard.size(), 250u);
    std::cout << listener.heard.size() << " texts\n";
    writeTranslation(folder.filePath("oversketch_eo.qm"), listener.heard);
    if (const QString wanted = qEnvironmentVariable("OVERSKETCH_TEXTS"); !wanted.isEmpty())
    {
      writeForLinguist(wanted, listener.heard);
    }
  }
  const QLocale esperanto(QLocale::Esperanto);
  EXPECT_FALSE(installTranslation(QLocale(QLocale::Welsh), folder.path())) << "there is none";
  ASSERT_TRUE(installTranslation(esperanto, folder.path()));
  int looked = 0;
  {
    Scene scene;
    for (const QSize& size : { QSize(1200, 800), QSize(800, 600) })
    {
      scene.window.resize(size);
      QApplication::processEvents();
      while (scene.document->canUndo())
      {
        scene.document->undo();
        scene.wait();
      }
      tour(scene,
        [&](const std::string& where)
        {
          EXPECT_LE(scene.window.width(), size.width()) << where;
          const auto* advice = scene.window.findChild<AdviceLabel*>();
          if (size.width() > 800) // there its tool tip may have the rest
          {
            EXPECT_EQ(advice->shown(), advice->text()) << where;
          }
          for (const std::string& text : cutOff(scene.window, looked))
          {
            ADD_FAILURE() << size.width() << " px, " << where << ": " << text;
          }
          for (const QString& text : textsOf(scene.window))
          {
            const bool isOfAnyLanguage =
              text.isEmpty() || text[0].isDigit() || QFileInfo(text).isAbsolute(); // a recent file
            EXPECT_TRUE(isOfAnyLanguage || text.contains(languageMark))
              << where << ", not translated: " << qPrintable(text);
          }
        });
    }
  }
  EXPECT_GT(looked, 300);
  for (QTranslator* one : QCoreApplication::instance()->findChildren<QTranslator*>())
  {
    delete one;
  }
}
