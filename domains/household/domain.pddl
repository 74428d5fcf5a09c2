; What the robot can do in a house. Positive STRIPS with types: planners that know no negation read it, so every pair of
; opposites (open/closed, hand-free/holding, ...) is two fluents that each effect keeps complementary.
; Names and parameters of actions are what the body's skills go by.
(define (domain household)
  (:requirements :strips :typing)

  (:types
    room thing slot fact - object
    position - object
    place person doorway - position)

  (:predicates
    ; where the robot is and how rooms hang together
    (in-room ?r - room)
    (at ?p - position)
    (within ?p - position ?r - room)
    (connects ?d - doorway ?a - room ?b - room)
    ; states; what has no door is open for ever; `ready`: a device that can be switched on, its door closed if it has one
    (open ?p - position) (closed ?p - position)
    (powered-on ?p - position) (powered-off ?p - position) (ready ?p - position)
    (hot ?t - thing) (cold ?t - thing)
    (clean ?o - object) (dirty ?o - object)
    (full ?o - object) (empty ?o - object)
    ; where things are; `carried`: in the hand or on the tray
    (lies ?t - thing ?p - place)
    (has ?q - person ?t - thing)
    (hand-free) (holding ?t - thing)
    (slot-free ?s - slot) (on-tray ?t - thing ?s - slot)
    (carried ?t - thing)
    ; what was found out or said
    (inspected ?p - place)
    (known ?f - fact) (about ?f - fact ?o - object)
    (told ?q - person)
    (followed ?q - person ?r - room)
    (accompanied ?q - person)
    ; what never changes
    (openable ?p - position) (switchable ?p - position)
    (heats ?p - place ?t - thing) (cools ?p - place ?t - thing) (washes ?p - place ?t - thing)
    (rinses ?p - place ?t - thing) (fills ?p - place ?t - thing) (drains ?p - place ?t - thing)
    (wipes ?t - thing ?p - place) (drainable ?p - place))

  ; -- moving -----------------------------------------------------------------------------------------------------------
  (:action move
    :parameters (?from - position ?to - position ?r - room)
    :precondition (and (in-room ?r) (at ?from) (within ?from ?r) (within ?to ?r))
    :effect (and (not (at ?from)) (at ?to)))

  (:action pass
    :parameters (?d - doorway ?a - room ?b - room)
    :precondition (and (in-room ?a) (at ?d) (connects ?d ?a ?b) (open ?d))
    :effect (and (not (in-room ?a)) (in-room ?b)))

  ; the person leads the way; both arrive in ?b, the robot still beside the person (whose `within` stays as it was: it is
  ; static, so that grounding stays small, and nobody plans on beyond a walk whose end is seen only then)
  (:action follow
    :parameters (?q - person ?a - room ?b - room)
    :precondition (and (in-room ?a) (at ?q) (within ?q ?a))
    :effect (and (not (in-room ?a)) (in-room ?b) (followed ?q ?b)))

  ; as `follow`, wherever the person likes to go
  (:action tag-along
    :parameters (?q - person)
    :precondition (and (at ?q))
    :effect (and (accompanied ?q)))

  ; -- opening, closing, switching --------------------------------------------------------------------------------------
  (:action open-up
    :parameters (?p - position)
    :precondition (and (at ?p) (openable ?p) (closed ?p))
    :effect (and (not (closed ?p)) (open ?p) (not (ready ?p))))

  (:action close-up
    :parameters (?p - position)
    :precondition (and (at ?p) (openable ?p) (open ?p))
    :effect (and (not (open ?p)) (closed ?p) (ready ?p)))

  (:action switch-on
    :parameters (?p - position)
    :precondition (and (at ?p) (switchable ?p) (powered-off ?p) (ready ?p))
    :effect (and (not (powered-off ?p)) (powered-on ?p)))

  (:action switch-off
    :parameters (?p - position)
    :precondition (and (at ?p) (switchable ?p) (powered-on ?p))
    :effect (and (not (powered-on ?p)) (powered-off ?p)))

  ; -- hand, tray, places, people ---------------------------------------------------------------------------------------
  (:action pick
    :parameters (?t - thing ?p - place)
    :precondition (and (at ?p) (lies ?t ?p) (open ?p) (hand-free))
    :effect (and (not (lies ?t ?p)) (not (hand-free)) (holding ?t) (carried ?t)))

  (:action place
    :parameters (?t - thing ?p - place)
    :precondition (and (at ?p) (open ?p) (holding ?t))
    :effect (and (not (holding ?t)) (not (carried ?t)) (hand-free) (lies ?t ?p)))

  (:action stow
    :parameters (?t - thing ?s - slot)
    :precondition (and (holding ?t) (slot-free ?s))
    :effect (and (not (holding ?t)) (not (slot-free ?s)) (hand-free) (on-tray ?t ?s)))

  (:action unstow
    :parameters (?t - thing ?s - slot)
    :precondition (and (on-tray ?t ?s) (hand-free))
    :effect (and (not (on-tray ?t ?s)) (not (hand-free)) (slot-free ?s) (holding ?t)))

  (:action give
    :parameters (?t - thing ?q - person)
    :precondition (and (at ?q) (holding ?t))
    :effect (and (not (holding ?t)) (not (carried ?t)) (hand-free) (has ?q ?t)))

  (:action receive
    :parameters (?t - thing ?q - person)
    :precondition (and (at ?q) (has ?q ?t) (hand-free))
    :effect (and (not (has ?q ?t)) (not (hand-free)) (holding ?t) (carried ?t)))

  ; -- bringing about states of things ----------------------------------------------------------------------------------
  (:action heat
    :parameters (?t - thing ?p - place)
    :precondition (and (at ?p) (lies ?t ?p) (closed ?p) (powered-off ?p) (heats ?p ?t))
    :effect (and (not (powered-off ?p)) (powered-on ?p) (not (cold ?t)) (hot ?t)))

  (:action wash
    :parameters (?t - thing ?p - place)
    :precondition (and (at ?p) (lies ?t ?p) (closed ?p) (powered-off ?p) (washes ?p ?t))
    :effect (and (not (powered-off ?p)) (powered-on ?p) (not (dirty ?t)) (clean ?t)))

  ; closing is what cools
  (:action chill
    :parameters (?t - thing ?p - place)
    :precondition (and (at ?p) (lies ?t ?p) (open ?p) (openable ?p) (cools ?p ?t))
    :effect (and (not (open ?p)) (closed ?p) (ready ?p) (not (hot ?t)) (cold ?t)))

  (:action rinse
    :parameters (?t - thing ?p - place)
    :precondition (and (at ?p) (holding ?t) (rinses ?p ?t))
    :effect (and (not (dirty ?t)) (clean ?t)))

  (:action fill
    :parameters (?t - thing ?p - place)
    :precondition (and (at ?p) (holding ?t) (fills ?p ?t))
    :effect (and (not (empty ?t)) (full ?t)))

  (:action drain
    :parameters (?t - thing ?p - place)
    :precondition (and (at ?p) (holding ?t) (drains ?p ?t))
    :effect (and (not (full ?t)) (empty ?t)))

  ; states of a place itself: a trash can is emptied with an empty hand, a surface is wiped with a rag
  (:action drain-place
    :parameters (?p - place)
    :precondition (and (at ?p) (drainable ?p) (hand-free))
    :effect (and (not (full ?p)) (empty ?p)))

  (:action wipe
    :parameters (?p - place ?t - thing)
    :precondition (and (at ?p) (holding ?t) (wipes ?t ?p))
    :effect (and (not (dirty ?p)) (clean ?p)))

  ; -- finding out and saying -------------------------------------------------------------------------------------------
  (:action inspect
    :parameters (?p - place)
    :precondition (and (at ?p) (open ?p))
    :effect (and (inspected ?p)))

  (:action sense
    :parameters (?f - fact ?t - thing ?p - place)
    :precondition (and (at ?p) (lies ?t ?p) (open ?p) (about ?f ?t))
    :effect (and (known ?f)))

  (:action sense-held
    :parameters (?f - fact ?t - thing)
    :precondition (and (carried ?t) (about ?f ?t))
    :effect (and (known ?f)))

  (:action sense-given
    :parameters (?f - fact ?t - thing ?q - person)
    :precondition (and (at ?q) (has ?q ?t) (about ?f ?t))
    :effect (and (known ?f)))

  (:action sense-place
    :parameters (?f - fact ?p - position)
    :precondition (and (at ?p) (about ?f ?p))
    :effect (and (known ?f)))

  (:action say
    :parameters (?q - person)
    :precondition (and (at ?q))
    :effect (and (told ?q))))
