#include "Mesh/message.h"

#include <gtest/gtest.h>

namespace oversketch
{

TEST(Message, HasItsArgumentsInItsPlaces)
{
  const Message message("%2 of %1, %1 %: %3", 7, 0.25, "a %1 {b}");
  EXPECT_EQ(message.id(), "%2 of %1, %1 %: %3");
  EXPECT_EQ(message.text(), "0.25 of 7, 7 %: a %1 {b}") << "what stands in a place is no place";
  EXPECT_TRUE(message.arguments()[1].isNumber);
  EXPECT_FALSE(message.arguments()[2].isNumber);
}

TEST(Message, OfAStringIsSaidAsItIs)
{
  EXPECT_EQ(Message(std::string("{Rule on} 100 %1")).text(), "{Rule on} 100 %1");
  EXPECT_TRUE(Message(std::string()).empty());
  EXPECT_TRUE(Message().empty());
}

TEST(Message, CallsWhatStandsInBracesAsTheHostDoes)
{
  const Message message(
    "{Stroke %1}: {AllowTorn on}, {Arrange off}, set {rule Off} or lower {seedMargin}", 3);
  EXPECT_EQ(
    message.text(), "Stroke 3: turn AllowTorn on, turn Arrange off, set Rule Off or lower SeedMargin");
  Message::Wording quoted;
  quoted.name = [](const std::string& named) { return '<' + named + '>'; };
  EXPECT_EQ(
    message.text(quoted), "<Stroke 3>: <AllowTorn on>, <Arrange off>, set <rule Off> or lower <seedMargin>");
  EXPECT_TRUE(message.names("AllowTorn on"));
  EXPECT_FALSE(message.names("AllowTorn off"));
}

TEST(Message, IsToldOfOtherStrokes)
{
  const Message message("%2: {Stroke %1} meets {stroke %3} near %1; %4",
    1,
    "{stroke %1}",
    2,
    Message::unusable("Stroke", 1, { "%1 px, {curve %1}", 2 }));
  EXPECT_EQ(message.renumbered([](int stroke) { return 10 * stroke + 1; }).text(),
    "{stroke %1}: Stroke 11 meets stroke 21 near 11; Stroke 11 cannot be used: 2 px, curve 2");
}

TEST(Message, HoldsOthersAndEachIsToldInTheHostsWords)
{
  const Message inner("%1 px off", 1.23456);
  const Message both(
    "Not as drawn: %1. %2", std::vector<Message>{ inner, { "%1 folds", 2 } }, Message("{Rule on}"));
  EXPECT_EQ(both.text(), "Not as drawn: 1.23456 px off; 2 folds. turn Rule on");
  EXPECT_TRUE(both.names("Rule on"));
  Message::Wording brief;
  brief.words = [](const std::string& text) { return text == "%1 px off" ? std::string("%1 beside") : text; };
  brief.number = [](const std::string& number) { return number.substr(0, 3); };
  EXPECT_EQ(both.text(brief), "Not as drawn: 1.2 beside; 2 folds. turn Rule on");
  EXPECT_EQ(Message::joined({ inner, inner }).text(), "1.23456 px off 1.23456 px off");
  EXPECT_EQ(Message::unusable("Stroke", 4, "it is closed.").text(), "Stroke 4 cannot be used: it is closed.");
}

} // namespace oversketch
