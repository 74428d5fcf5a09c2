"""Words that point, name people or lead phrases: what rules and references both know of single words."""

from __future__ import annotations

PLACE_ADVERBS = frozenset("upstairs downstairs outside inside".split())
"""Where something is or goes, in one word."""
PREPOSITIONS = frozenset(
    "in on at to from into onto inside under underneath behind beside near nearer by with off out of for over next up "
    "down through along across around round between after towards toward above below upon w".split()
)
POINTING = frozenset(
    "me us you i my mine we here something anything everything somebody someone anyone anybody everyone everybody "
    "nobody nothing none here case".split()
)
WHOLE = frozenset("something anything everything somebody someone anyone anybody everyone everybody".split())
"""Words that point to nothing said before but that something said after may refer to."""
ANIMALS = frozenset(
    "dog cat puppy kitten hamster rabbit parrot bird horse pony goat pig hen chicken duck fish tortoise turtle budgie "
    "gerbil mouse rat sheep lamb cow donkey goldfish pup bunny pet".split()
)
PERSON_NOUNS = frozenset(
    "wife husband mother father mom mum dad son daughter brother sister guest visitor neighbour neighbor colleague "
    "boss friend nurse doctor kid kids child children baby man woman lady guy girl boy grandma grandpa granny grandad "
    "nan aunt uncle cousin roommate flatmate plumber cleaner electrician driver postman courier teacher student "
    "professor people everyone family partner girlfriend boyfriend mama papa granddaughter grandson person carer "
    "caretaker gardener vet tenant patient customer client manager technician resident caller vendor minister "
    "lad lass lassie mate pal buddy bloke fella fellow chap toddler teenager twin sibling granddad nephew niece "
    "gentleman janitor receptionist mechanic midwife vicar landlord landlady lodger builder roofer chef waiter "
    "waitress butler maid nanny babysitter housekeeper handyman milkman mailman salesman watchman policeman "
    "policewoman postwoman locksmith glazier carpenter decorator surveyor photographer hairdresser barber "
    "physiotherapist dentist therapist chaplain pastor priest clerk porter pupil organist tailor butcher baker grocer "
    "florist chemist pharmacist".split()
)
"""Nouns for people."""
ANYBODY = frozenset("anyone anybody someone somebody whoever".split())
"""Words for people of whom it may then be said that nobody is so."""
QUANTIFIERS = frozenset("any some enough more no another".split())
PRONOUNS = frozenset(
    "it that this one another some any them they 'em em these those ones both him her he she there which two three "
    "four mine his hers yours theirs ours".split()
)
PASSAGES = frozenset("door gate hatch window flap shutter".split())
"""What shuts off a way through, and is no thing on its own."""
ONES = frozenset(("one", "ones"))
"""What stands for a noun that was named: "the blue *one*"."""
ROOM = frozenset(("room", "space"))
"""What there may be none of for something to be put."""
TIME_UNITS = frozenset("second minute hour day week month".split())
LEVELS = frozenset("below above under over".split())
SHARES = frozenset(("half", "all", "both"))
"""What stands ahead of "the" or "a" for how much of something is meant."""
