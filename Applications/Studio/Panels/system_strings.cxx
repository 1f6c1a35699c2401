#include "system_strings.h"

#include "systems.h"

#include <QCoreApplication>

namespace oversketch_studio
{

QString rowText(const std::string& text)
{
  return text.empty() ? QString() : QCoreApplication::translate("Systems", text.c_str());
}

QString rowSentence(const std::string& text)
{
  QString sentence = rowText(text);
  return sentence.isEmpty() ? sentence : sentence[0].toUpper() + sentence.mid(1);
}

QString titleOf(const std::string& system)
{
  const auto* row = oversketch_session::findSystem(system);
  return row ? rowText(row->title) : QString::fromStdString(system);
}

QStringList listOf(const std::vector<std::string>& texts)
{
  QStringList list;
  for (const std::string& text : texts)
  {
    list << QString::fromStdString(text);
  }
  return list;
}

} // namespace oversketch_studio
