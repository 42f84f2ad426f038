// The parity game of a deterministic parity automaton whose propositions are inputs and outputs.
//
// In each round the environment chooses the inputs of the next letter, then the system the outputs, then the automaton
// reads the letter. The system wins a play when the word is accepted, so it can realise the language, as a Mealy
// machine, exactly when it wins from the initial vertex. Vertices of the environment are pairs of a state and the
// colour of the edge into it; a vertex of the system is what the inputs leave of a transition function. A letter on
// which the automaton rejects leads to a vertex that the system loses. Source: [PR89].
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "libautomata/deterministic/parity.hpp"

namespace waymark::automata {

struct ParityGame {
  enum class Player : std::uint8_t { System = 0, Environment = 1 };  // who chooses a successor
  struct Vertex {                                                    // a position of the game
    Player owner;                                                    // that chooses
    std::uint32_t priority;                 // the greatest that occurs infinitely often decides; even: the system wins
    std::vector<std::uint32_t> successors;  // at least one
    std::string name;                       // of a vertex of the environment: the state, and the colour behind a slash
  };
  std::vector<Vertex> vertices;  // 0 is the initial one
};

// `outputs`: propositions of the automaton's vocabulary; all others are inputs. Throws what the budget throws: a state
// for each vertex.
ParityGame parity_game(const Dpa& automaton, const std::vector<ltl::Proposition>& outputs, Budget& budget);

// The format of PGSolver, which Spot's ltlsynt --print-pg prints, too: `parity N;`, then a line for each vertex with
// its number, priority, owner, successors and name. Source: [FL09].
std::string write_pgsolver(const ParityGame& game);

}  // namespace waymark::automata
