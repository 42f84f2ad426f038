#include "libparser/domain/commands/states.hpp"

#include <algorithm>
#include <array>
#include <sstream>
#include <string_view>

#include "libparser/domain/commands/word_forms.hpp"

namespace waymark::parser {
namespace {

struct StateRow {  // words that say the same, and those that say the opposite
  std::string_view words, opposites;
};
constexpr std::array state_rows{
    StateRow{"on active activate enabled running powered switched lit", "off inactive disabled deactivated stopped"},
    StateRow{"open ajar unlocked", "shut closed close"},
    StateRow{"up raised lifted aloft lift raise", "down lowered lower"},
    StateRow{"high excessive excess elevated", "low"},
    StateRow{"low weak flat feeble drained ebb dying", "charged strong fine okay"},
    StateRow{"hot warm heated overheated heat overheat overtemperature", "cold cool chilly"},
    StateRow{"temperature heat hot overheat overtemperature", ""},
    StateRow{"full brimming filled fill brim brimful crammed", "empty emptied drained"},
    StateRow{"locked bolted lock", "unlocked"},
    StateRow{"in inside within", "out outside absent"},
    StateRow{"at present there", "away elsewhere off absent"},
    StateRow{"on aboard astride upon", "off away clear free"},
    StateRow{"near close nearby around proximity beside", "far away distant"},
    StateRow{"sound ring blare wail peal chime sing noise audible", "silent quiet silence mute hushed still"},
    StateRow{"run operate work underway progress active operation", "stop halted idle stopped"},
    StateRow{"start begin launch ignite ignition", "stop end finish"},
    StateRow{"hold held taken grab keep acquire", "released free release"},
    StateRow{"apply engaged engage on", "released disengaged release off"},
    StateRow{"press push pushed hit", "released"},
    StateRow{"idle inactive dormant resting rest", "busy working active occupied"},
    StateRow{"green", "red amber"},
    StateRow{"dark night nightfall dusk", "light day daylight bright"},
    StateRow{"airborne aloft fly air hover flight", "grounded ground landed"},
    StateRow{"give grant issue", "withhold withheld deny denied refuse"},
    StateRow{"send dispatch transmit", ""},
    StateRow{"arrive incoming come reach", "depart leave"},
    StateRow{"approve accept okayed authorised authorized cleared", "rejected refused declined reject refuse decline"},
    StateRow{"confirm acknowledge okay approve", "deny"},
    StateRow{"ship dispatched sent despatched", "pending"},
    StateRow{"drop fall sink decrease decline lower ebb", "rise climb increase"},
    StateRow{"see detect spot sight view notice perceive", "miss"},
    StateRow{"carry bear hold laden transport loaded", "unladen unloaded"},
    StateRow{"write save store", ""},
    StateRow{"record film", ""},
    StateRow{"ready done prepared", ""},
    StateRow{"heavy dense jam congested", "light thin"},
    StateRow{"due owed", ""},
    StateRow{"assert active high raised", "deasserted low inactive"},
    StateRow{"flush clear empty", ""},
    StateRow{"return back", ""},
    StateRow{"someone somebody person anyone anybody people human", ""},
    StateRow{"call cry shout yell", ""},
    StateRow{"wet damp moist", "dry"},
    StateRow{"clean", "dirty"},
    StateRow{"safe secure", "dangerous hazardous"},
    StateRow{"connected attached plugged", "detached unplugged"},
    StateRow{"occupied taken", "vacant free"},
    StateRow{"visible shown", "hidden"},
    StateRow{"awake", "asleep sleeping"},
    StateRow{"moving move motion", "still stationary standing"},
    StateRow{"pass succeed success", "fail failure"},
    StateRow{"win victory", "lose defeat"},
    StateRow{"alive", "dead"},
    StateRow{"fast quick", "slow"},
    StateRow{"left", "right"},
    StateRow{"above over", "below under"},
    StateRow{"inserted", "removed"},
    StateRow{"healthy good fine okay ok", "faulty bad broken defective"},
    StateRow{"logged signed", ""},
    StateRow{"customer client", ""},
    StateRow{"lift elevator", ""},
    StateRow{"maintenance upkeep servicing", ""},
    StateRow{"acknowledgement ack acknowledgment", ""},
    StateRow{"rain raining downpour", "dry"},
    StateRow{"train railway rail", ""},
    StateRow{"pharmacy chemist drugstore", ""},
    StateRow{"flower florist", ""},
    StateRow{"gas petrol fuel filling", ""},
    StateRow{"construction building", ""},
    StateRow{"parking car", ""},
    StateRow{"place spot joint restaurant eatery shop store bar parlour parlor", ""},
    StateRow{"cinema movie film picture", ""},
    StateRow{"bookstore bookshop bookseller", ""}};

struct RelatedRow {
  std::vector<std::string> words, opposites;
};

std::vector<std::string> bases_of(std::string_view words) {
  std::istringstream in{std::string(words)};
  std::vector<std::string> out;
  for (std::string word; in >> word;) out.push_back(base_form(word));
  return out;
}

const std::vector<RelatedRow>& rows_of_states() {
  static const std::vector<RelatedRow> rows = [] {
    std::vector<RelatedRow> all;
    for (const StateRow& row : state_rows) all.push_back({bases_of(row.words), bases_of(row.opposites)});
    return all;
  }();
  return rows;
}

}  // namespace

std::vector<RelatedState> related_states(const std::string& word) {
  const std::string base = base_form(word);
  const auto has = [&](const std::vector<std::string>& words) {
    return std::any_of(words.begin(), words.end(), [&](const std::string& other) { return same_family(base, other); });
  };
  std::vector<RelatedState> out;
  const auto add = [&](const std::vector<std::string>& words, bool opposite) {
    for (const std::string& other : words)
      if (!same_family(base, other)) out.push_back({other, opposite});
  };
  for (const RelatedRow& row : rows_of_states())
    for (const bool swapped : {false, true})
      if (has(swapped ? row.opposites : row.words)) {
        add(swapped ? row.opposites : row.words, false);
        add(swapped ? row.words : row.opposites, true);
      }
  return out;
}

}  // namespace waymark::parser
