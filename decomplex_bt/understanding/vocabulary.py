"""Words that point, name people or lead phrases: what rules and references both know of single words."""

from __future__ import annotations

PLACE_ADVERBS = frozenset("upstairs downstairs outside inside".split())
"""Where something is or goes, in one word."""
PREPOSITIONS = frozenset(
    "in on at to from into onto inside under underneath behind beside near nearer by with off out of for over next up "
    "down through along across around round between after towards toward above below upon w".split()
)
WARMTH = frozenset("hot cold warm freezing chilly cool stuffy nippy muggy humid".split())
"""How the air may be."""
AIRED = frozenset(
    "window fan blind curtain shutter awning door heating heater fire fireplace aircon ac jumper jacket coat sweater "
    "cardigan scarf hat glove blanket parasol skylight umbrella thermostat ventilator drape duvet hoodie".split()
)
"""What is seen to, put on or fetched for how warm it is around."""
TIMES_OF_DAY = frozenset("morning afternoon evening night noon midday midnight".split())
WEEKDAYS = frozenset("monday tuesday wednesday thursday friday saturday sunday".split())
POINTING = frozenset(
    "me us you i my mine we here something anything everything somebody someone anyone anybody everyone everybody "
    "nobody nothing none here case".split()
)
WHOLE = frozenset("something anything everything somebody someone anyone anybody everyone everybody".split())
"""Words that point to nothing said before but that something said after may refer to."""
PETS = frozenset(
    "beagle bird budgie canary cat cockatiel collie dachshund dog doggy donkey ewe foal gerbil greyhound hamster "
    "heifer hen horse hound kitten kitty labrador magpie mare mutt parrot piglet pony pooch poodle pup puppy rabbit "
    "retriever spaniel tabby terrier tomcat tortoise whippet".split()
)
"""Animals that are somebody, not food, wherever they are named."""
ANIMALS = PETS | frozenset("bunny chicken cow duck fish goat goldfish lamb mouse pet pig rat sheep turtle".split())
PERSON_NOUNS = frozenset(
    "accountant actor actress administrator adult apprentice architect archivist artist assistant auditor aunt auntie "
    "baby babysitter bailiff baker ballerina barber barista barmaid barman barrister bassist beautician bellboy "
    "blacksmith bloke boss boy boyfriend bricklayer bride bridegroom bridesmaid brother buddy builder butcher "
    "butler caller cardiologist carer caretaker carpenter caterer cellist chairman chairwoman chambermaid chap "
    "chaplain chauffeur chef chemist child childminder children chiropodist choirboy choirmaster churchwarden cleaner "
    "clerk client cobbler colleague composer concierge conservator constable councillor counsellor courier cousin "
    "crewman curate curator customer dad daddy daughter daughter-in-law dean deckhand decorator dentist deputy "
    "designer detective dietician director dispatcher doctor doorman driver drummer editor electrician engineer "
    "everyone family father father-in-law fella fellow fiance fiancee firefighter fireman fisherman fishmonger "
    "flatmate flautist florist foreman friend gamekeeper gardener gentleman girl girlfriend glazier goddaughter "
    "godfather godmother godson goldsmith governess gran grandad grandbaby grandchild granddad granddaughter "
    "grandfather grandma grandmother grandpa grandparent grandson granny greengrocer grocer groundsman guardian guest "
    "guitarist guy hairdresser hairstylist handyman harbourmaster harpist headmaster headmistress heir heiress helper "
    "historian hostess housekeeper housemaid housemate housemother husband hygienist illustrator infant inspector "
    "instructor intern janitor jeweller joiner journalist juror kid kids lad lady landlady landlord lass lassie "
    "lawyer lecturer librarian lifeguard locksmith locum lodger magistrate maid mailman mam mama man manager masseur "
    "masseuse mate matron mayor mechanic mentor midwife milkman minister mom mother mother-in-law mum mummy musician "
    "nan nana nanny neighbor neighbour nephew neurologist newborn newcomer niece nun nurse nursemaid obstetrician "
    "officer optician organist orphan osteopath owner paediatrician pal papa paramedic parent parishioner parson "
    "partner passenger pastor patient pedestrian pensioner people person pharmacist photographer physician physio "
    "physiotherapist pianist plasterer playmate plumber podiatrist poet policeman policewoman porter postie postman "
    "postmistress postwoman preacher president priest priestess princess principal professor psychiatrist "
    "psychologist publican pupil quartermaster rabbi radiographer realtor receptionist rector referee registrar "
    "relative resident retiree roofer roommate sacristan sailor salesman saxophonist schoolboy schoolgirl schoolmate "
    "scientist seamstress secretary sergeant servant sexton sheriff shopkeeper sibling singer sister "
    "sister-in-law soldier solicitor soloist son son-in-law soprano sportsman stepbrother stepdaughter stepfather "
    "stepmother stepsister stepson steward stewardess stonemason stranger student supervisor supplier surgeon "
    "surveyor sweetheart swimmer tailor teacher teammate technician teen teenager tenant therapist tiler toddler "
    "trainee translator traveller treasurer trumpeter tutor twin typist umpire uncle understudy undertaker "
    "upholsterer usher valet vendor verger vet veteran vicar violinist visitor volunteer waiter waitress warden "
    "washerwoman watchmaker watchman welder widow widower wife woman workman yachtsman youngster zookeeper".split()
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
