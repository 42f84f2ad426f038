#include "tools/studio/api.hpp"

#include <algorithm>
#include <array>

#include "libltl/diagnostic.hpp"
#include "libltl/watch.hpp"
#include "tools/shell/exit_code.hpp"
#include "tools/studio/formulas.hpp"
#include "tools/studio/maps.hpp"
#include "tools/studio/tasks.hpp"
#include "tools/studio/values.hpp"
#include "tools/studio/walks.hpp"

namespace waymark::studio {
namespace {

using tools::JsonObject;

struct Endpoint {
  std::string_view path;
  JsonObject (*answer)(const Request&, const Context&);
};

constexpr std::array endpoints{
    Endpoint{"/api/map", show_map},
    Endpoint{"/api/run", run_instruction},
    Endpoint{"/api/words", trace_words},
    Endpoint{"/api/plan", plan_formula},
    Endpoint{"/api/picture", draw_plan},
    Endpoint{"/api/formula", write_formula},
    Endpoint{"/api/explain", explain_formula},
    Endpoint{"/api/translate", translate_formula},
    Endpoint{"/api/automaton", draw_automaton},
    Endpoint{"/api/check", check_walk},
    Endpoint{"/api/values", value_poses},
    Endpoint{"/api/prism", write_product},
    Endpoint{"/api/learn", learn_task},
};

JsonObject dispatch(std::string_view method, std::string_view path, std::string_view body, const Context& context) {
  const bool lists = path == "/api/maps";
  if (lists && method == "GET") return list_maps(context);
  if (lists && method == "POST") {
    check_json_bounds(body);
    return add_map(body, context);
  }
  const auto endpoint =
      std::find_if(endpoints.begin(), endpoints.end(), [&](const Endpoint& e) { return e.path == path; });
  if (endpoint == endpoints.end() && !lists) throw RequestError(404, "not found", "there is no such answer");
  if (lists || method != "POST") throw RequestError(405, "method", "this answer is asked for by POST");
  return endpoint->answer(Request(body), context);
}

ApiAnswer failure(int status, const std::string& kind, const std::string& message) {
  return {status, JsonObject().add("error", JsonObject().add("kind", kind).add("message", message)).text()};
}

// Places are counted in characters, as a page counts them.
ApiAnswer failure(const ltl::SyntaxError& error, std::string_view body) {
  const std::string text = Request(body).text_or("formula", "");
  const auto characters = [&](std::size_t bytes) { return ltl::utf8_length(std::string_view(text).substr(0, bytes)); };
  return {422, JsonObject()
                   .add("error", JsonObject()
                                     .add("kind", "syntax")
                                     .add("message", error.message())
                                     .add("begin", characters(error.where().begin))
                                     .add("end", characters(error.where().end)))
                   .text()};
}

}  // namespace

ApiAnswer Api::answer(std::string_view method, std::string_view path, std::string_view body,
                      const std::stop_token& stop) {
  struct Place {  // among the requests at once
    std::atomic<int>& count;
    int taken = ++count;
    ~Place() { --count; }
  };
  const Place place{at_once_};
  if (place.taken > most_at_once) return failure(503, "busy", "too many requests at once");
  if (path != "/api/automaton" && path != "/api/picture") return answer_within(method, path, body, stop);
  const Place among_pictures{drawn_at_once_};
  if (among_pictures.taken > most_drawn_at_once) return failure(503, "busy", "too many pictures at once");
  return answer_within(method, path, body, stop);
}

ApiAnswer Api::answer_within(std::string_view method, std::string_view path, std::string_view body,
                             const std::stop_token& stop) {
  const ltl::Watch watch({.seconds = seconds_}, stop);
  try {
    return {200, dispatch(method, path, body, {reader_, worlds_, watch.token()}).text()};
  } catch (const RequestError& error) {
    return failure(error.status(), error.kind(), error.what());
  } catch (const ltl::SyntaxError& error) {
    return failure(error, body);
  } catch (const ltl::FormatError& error) {
    return failure(422, "format", error.what());
  } catch (const tools::UsageError& error) {
    return failure(422, "usage", error.what());
  } catch (const tools::GaveUp& error) {
    return failure(422, "limit", watch.overrun() == ltl::Overrun::Time ? "no answer within ten seconds" : error.what());
  } catch (const std::bad_alloc&) {
    return failure(500, "limit", "out of memory");
  } catch (const std::exception& error) {
    return failure(500, "defect", error.what());
  }
}

}  // namespace waymark::studio
