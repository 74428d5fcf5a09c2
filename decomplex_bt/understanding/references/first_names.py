"""First names that are hardly ever another gender's; those of both ("Alex", "Sam", "Robin") are left out."""

from __future__ import annotations

WOMEN = frozenset(
    "abigail ada adele agnes aisha alice alicia alison amanda amelia amina amy ana anita anna anne annie anya "
    "astrid ava barbara beatrice becky bella beth betty birgit brenda bridget carla carmen carol caroline catherine "
    "cecilia celia chantal charlotte chiara chloe christina claire clara claudia cynthia daisy deborah denise diana "
    "donna dora doris dorothy edith eileen elaine elena elisa elizabeth ella ellen elsa elsie emilia emily emma "
    "erica esther ethel eva eve evelyn fatima fiona flora florence freya frieda gemma georgia gerda gina giulia "
    "gloria grace greta hannah harriet hazel heather heidi helen helena hilda holly ida imogen ines ingrid irene "
    "iris isabel isabella isla ivy jane janet jasmine jennifer jess jenny jessica joan joanna josephine judith judy "
    "julia juliet karen kate katherine kathleen katie kirsten lara laura leila lena lily linda lisa liz lola lorna "
    "louisa louise lucia lucy lydia madeleine maggie margaret maria marie marina marion martha mary matilda maud "
    "maya megan mei melanie melissa mia michelle mila millie mina miriam moira molly monica nadia nancy naomi "
    "natalie natasha nina nora olga olive olivia patricia paula pauline penelope petra phoebe pia polly priya "
    "rachel rebecca renata rita rosa rose rosemary rosie ruby ruth sabine sally samantha sandra sara sarah selma "
    "sheila shirley silvia simone sofia sonia sophia sophie stella stephanie sue susan susanna suzanne sylvia "
    "tamara tanya teresa tess tessa theresa tina trudy ursula valerie vanessa vera veronica victoria violet vivian "
    "wendy yasmin yolanda yvonne zara zoe zuzana".split()
)
MEN = frozenset(
    "aaron adam adrian ahmed alan albert alfie alfred ali amir andreas andrew andy anton antonio arjun arthur barry "
    "ben benjamin bernard bill bob boris brian bruno callum carl carlos cedric charles clive colin craig dan daniel "
    "darren dave david dennis derek diego dieter dimitri dominic don donald douglas duncan ed eddie edgar eduardo "
    "edward emil enrico eric ernest ethan fabio felix fernando frank fred frederick gareth gary geoff george gerald "
    "gianni giovanni gordon graham greg gregory gustav hamza hans harold harry hassan hector henry herbert howard "
    "hugh hugo ian ibrahim igor isaac ivan jack jacob jake james jason javier jeff jeremy jerome jim jimmy joe joel "
    "john johnny jonas jonathan jorge jose joseph josh joshua juan julian karim karl keith ken kenneth kevin klaus "
    "kofi kurt lars laurence leo leon leonard liam lorenzo louis lucas luigi luis luke marcel marco marcus mario "
    "mark markus martin mateo matthew maurice max michael miguel mike milan mohammed muhammad nathan neil nigel "
    "noah norman oliver omar oscar otto pablo patrick paul pavel pedro peter phil philip pierre rafael raj ralph "
    "raymond richard rob robert roberto roger roland ron ronald rory roy rupert samuel sanjay sean sebastian sergei "
    "simon stanley stefan stephen steve steven stuart ted terence theo thomas tim timothy tobias tom tomas tommy "
    "tony trevor umberto vernon victor vikram viktor vincent vladimir walter wayne wilfred will william winston "
    "yusuf zachary".split()
)
