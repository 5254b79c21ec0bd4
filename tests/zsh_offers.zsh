# zsh_offers.zsh SCRIPT LINE: prints what zsh offers when Tab is pressed behind the line, in a terminal of its own.
zmodload zsh/zpty
zpty shell zsh -f -i
zpty -w shell "PS1=; stty cols 400 rows 1000; LISTMAX=10000; autoload -Uz compinit; compinit -u -D; setopt no_auto_menu no_beep"
zpty -w shell "source_wend() { functions[_wend]=\"\$(<$1)\"; }; source_wend; compdef _wend wend; zstyle ':completion:*' list-prompt ''; print re''ady"
zpty -r -m shell answer '*ready*'
zpty -w -n shell "$2"$'\t\x15'
zpty -w shell "print fini''shed"
zpty -r -m shell text '*finished*'
print -r -- "$text"
zpty -d shell
